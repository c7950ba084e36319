// Transfer of films between ranks: heads as in film files, sums as in memory.
//
// All ranks run one program on machines of one byte order, so the format needs no version.
#pragma once

#include "film/film.h"
#include "ranks/ranks.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Sends numbers whose count the receiver knows.
void send_words(const Ranks& ranks, int to, const std::vector<std::uint64_t>& words);
std::vector<std::uint64_t> receive_words(const Ranks& ranks, int from, std::size_t count);

/// Sends a film to another rank, in as many bytes as its sums plus some hundreds.
void send_film(const Ranks& ranks, int to, const Film& film);
Film receive_film(const Ranks& ranks, int from);

}  // namespace sunfleck::engine
