// Films on their way between ranks: heads as in film files, sums as they stand in memory.
//
// All ranks run one program on machines of one byte order, so there is no format to keep.
#pragma once

#include "film/film.h"
#include "ranks/ranks.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Numbers whose count the receiver knows.
void send_words(const Ranks& ranks, int to, const std::vector<std::uint64_t>& words);
std::vector<std::uint64_t> receive_words(const Ranks& ranks, int from, std::size_t count);

/// The film moves to another rank. Bytes: those of its sums, and some hundreds.
void send_film(const Ranks& ranks, int to, const Film& film);
Film receive_film(const Ranks& ranks, int from);

}  // namespace sunfleck::engine
