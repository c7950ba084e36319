// What stands in a film file before its sums: from it a reader knows how many follow.
#pragma once

#include "film/film_sums.h"
#include "film/word_file.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// The first word of a film: "sunfilm\n".
inline constexpr std::uint64_t kFilmMagic = 0x0A'6D'6C'69'66'6E'75'73;

struct FilmHead {
    FilmKey key;
    PassSet passes;
    HeavyPasses heavy;
    FilmStatistics statistics;
};

/// The head as words, magic and version first (film_file.h has the layout).
std::vector<std::uint64_t> head_words(const FilmSums& sums);

/// The same back. @throws Error for what is none, or of another version.
FilmHead take_head(WordReader& in);

/// The groups of open batches whose sums stand in a film of that head.
std::vector<PassRange> open_groups(const FilmHead& head);

/// A film of that head, all its sums zero.
FilmSums empty_sums(FilmHead head);

}  // namespace sunfleck::engine
