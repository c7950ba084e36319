// Reduction intervals: the passes that ranks render between two synchronisations.
//
// An interval is a range of passes, divided among the ranks in blocks of consecutive passes whose
// sizes differ by at most one. At its end rank 0's film has all of them, so that a render ends
// without gaps, and rank 0 can check limits and write snapshots and checkpoints like a single
// machine.
#pragma once

#include "film/pass_set.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Returns the passes of rank `rank` of `size`; may be empty.
PassRange block_of(const PassRange& interval, int rank, int size);

/// Divides an interval after the last pass of each batch: after each part, the film can be asked
/// for its error.
std::vector<PassRange> cut_at_batches(const PassRange& interval);

/// Returns the intersection of two ranges.
PassRange common(const PassRange& a, const PassRange& b);

/// Inputs that decide the length of the next interval.
struct IntervalLimits {
    int ranks = 1;
    double pass_seconds = 0;  // per rank, in the last interval; zero without one
    double seconds = 0;       // limit of the duration, but at least one pass per rank
    bool batches = false;     // the render may end at a batch, so that later passes are lost
    std::optional<std::uint64_t> at_most;  // passes; at least one
};

/// Returns the number of passes: as many per rank as take `seconds`, at least one. A single rank
/// has one.
std::uint64_t passes_of_interval(const IntervalLimits& limits);

}  // namespace sunfleck::engine
