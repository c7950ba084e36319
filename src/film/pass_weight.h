// Weights of the passes of a film.
//
// The first passes of a large picture are small, so that the picture and its error come early
// (render/pass.h): a quarter of the photon paths, and one camera path a pixel. Their variance is
// about four times that of others, so each counts a quarter in all means. Where this file's callers
// speak of a number of passes of a mean, a small pass is a quarter of one.
#pragma once

#include "film/film_key.h"
#include "film/pass_set.h"

#include <algorithm>
#include <cstdint>

namespace sunfleck::engine {

/// The small passes of a large picture. Their wavelengths, and those of the other passes of their
/// batch, are evenly spread (pass_groups.h): those of two would not be.
inline constexpr std::uint64_t kSmallPasses = 4;
/// A small pass is 2^-kSmallPassBits of another.
inline constexpr unsigned kSmallPassBits = 2;

inline bool is_small(const FilmKey& key, std::uint64_t pass) {
    return pass < key.small_passes;
}

/// Returns the binary digits by which the terms of a pass are shifted down.
inline unsigned bits_less(const FilmKey& key, std::uint64_t pass) {
    return is_small(key, pass) ? kSmallPassBits : 0;
}

inline double weight_of(const FilmKey& key, std::uint64_t pass) {
    return is_small(key, pass) ? 1.0 / (1U << kSmallPassBits) : 1;
}

/// Returns the weight of so many passes, some of which are small.
inline double weight_of(const FilmKey& key, std::uint64_t passes, std::uint64_t small) {
    return static_cast<double>(passes) - (1 - weight_of(key, 0)) * static_cast<double>(small);
}

/// Returns the small passes of a range.
inline PassRange small_in(const FilmKey& key, const PassRange& range) {
    return {range.begin, std::clamp(key.small_passes, range.begin, range.end)};
}

/// Returns the sum of the weights of those passes of a range that are in the set.
inline double weight_in(const FilmKey& key, const PassSet& passes, const PassRange& range) {
    return weight_of(key, passes.count_in(range), passes.count_in(small_in(key, range)));
}

/// Returns the sum of the weights of all passes of a range.
inline double weight_in(const FilmKey& key, const PassRange& range) {
    return weight_of(key, range.size(), small_in(key, range).size());
}

}  // namespace sunfleck::engine
