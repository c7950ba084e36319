// Sums over complete batches, early ones among them (batches.h).
#pragma once

#include "film/batches.h"
#include "film/film_sums.h"
#include "film/pass_groups.h"
#include "math/wavelengths.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// A group of passes of no complete batch.
struct OpenPasses {
    std::uint64_t first;
    const OpenGroup* sums;
};

/// Returns the groups whose passes belong to no complete batch.
inline std::vector<OpenPasses> passes_left_out(const FilmSums& sums) {
    std::vector<OpenPasses> groups;
    for (const auto& [first, group] : sums.open_groups)
        if (!is_early(sums.passes, group_of(sums.passes, first))) groups.push_back({first, &group});
    return groups;
}

/// Returns the sum over complete batches of their squares, each times the passes of its batch.
/// @param whole  of one quantity, in FilmSums. @param early  of the same, in EarlySums.
inline double square_sum(const FixedPoint& whole, const FixedPoint& early) {
    return kBatchPasses * whole.to_double() + early.to_double();
}

/// The same of quantity i of many. @param early  empty if there are no early batches.
inline double square_sum(const FixedPoints& whole, const FixedPoints& early, std::size_t i) {
    return square_sum(whole[i], early.empty() ? FixedPoint() : early[i]);
}

}  // namespace sunfleck::engine
