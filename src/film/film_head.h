// The head of a film file, from which a reader knows how many sums follow.
#pragma once

#include "film/film_sums.h"
#include "film/word_file.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// The first word of a film file: "sunfilm\n".
inline constexpr std::uint64_t kFilmMagic = 0x0A'6D'6C'69'66'6E'75'73;

struct FilmHead {
    FilmKey key;
    PassSet passes;
    FilmStatistics statistics;
};

/// Returns the head as words, beginning with magic and version (layout: film_file.h).
std::vector<std::uint64_t> head_words(const FilmSums& sums);

/// Reads a head. @throws Error  for an invalid one, and for another version.
FilmHead take_head(WordReader& in);

/// Returns the groups of open batches whose sums follow this head.
std::vector<PassRange> open_groups(const FilmHead& head);

/// Returns a film with this head and sums of zero.
FilmSums empty_sums(FilmHead head);

}  // namespace sunfleck::engine
