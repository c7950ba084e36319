// Batches: groups of passes whose means are the independent samples of error bars.
//
// A whole batch is the kBatchPasses passes whose wavelengths form one lattice. Until
// kWholeBatches of them are complete, the groups of the first one (pass_groups.h) count as batches
// of their own, early ones, so that errors are known from two passes on. They are not kept for
// longer: the passes of a whole batch are more evenly spread than its parts, which makes error bars
// from early batches a little too large, and much too large for lamps with spectral lines.
// Equations: docs/method/errors.md, eq. (26).
#pragma once

#include "film/film_key.h"
#include "film/pass_set.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Complete whole batches from which on there are no early ones.
inline constexpr std::uint64_t kWholeBatches = 4;

/// Returns the passes of a whole batch.
PassRange batch_range(std::uint64_t batch);

/// Returns the number of complete whole batches.
std::uint64_t whole_batches(const PassSet& passes);

/// Returns whether early batches count, and some of their passes are there.
bool has_early_batches(const PassSet& passes);

/// Returns the early batches that are complete, ascending; none unless they count.
std::vector<PassRange> early_batches(const PassSet& passes);

/// Returns whether all passes of a group of an open batch belong to complete early batches.
/// @param group  of group_of().
bool is_early(const PassSet& passes, const PassRange& group);

/// The batches that errors are computed from. They have different numbers of passes.
struct CompleteBatches {
    double count = 0;
    double passes = 0;  // of all of them, by their weights (pass_weight.h)
};

CompleteBatches complete_batches(const FilmKey& key, const PassSet& passes);

/// Returns the mean disc area of passes, relative to pass 0 (visible_points/radius.h).
/// @param key  with discs. @param range  not empty.
double area_of(const FilmKey& key, const PassRange& range);

/// Returns the end of the first batch, early or whole, that ends behind a pass.
std::uint64_t next_batch_end(std::uint64_t pass);

}  // namespace sunfleck::engine
