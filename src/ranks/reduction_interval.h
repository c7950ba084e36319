// Reduction intervals: which passes the ranks render between two points at which all meet.
//
// An interval is a run of passes, dealt to the ranks in blocks of neighbouring passes that differ
// by one at most. At its end all of them are in rank 0's film, so that a render ends without a
// hole, and so that rank 0 can ask what one machine asks: limits, snapshots, checkpoints.
#pragma once

#include "film/pass_set.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// Passes of rank `rank` of `size`; may be empty.
PassRange block_of(const PassRange& interval, int rank, int size);

/// An interval cut after each last pass of a batch: at each cut, and at the end, the film can be
/// asked for its error.
std::vector<PassRange> cut_at_batches(const PassRange& interval);

/// Passes of two ranges.
PassRange common(const PassRange& a, const PassRange& b);

/// What decides how long the next interval is.
struct IntervalLimits {
    int ranks = 1;
    double pass_seconds = 0;  // of a rank, as in the last interval; zero: there was none
    double seconds = 0;       // the interval should not take longer, but for a pass a rank
    bool batches = false;     // the render may end at a batch: what is beyond is lost
    std::optional<std::uint64_t> at_most;  // passes; at least one
};

/// Its passes: so many for each rank that it lasts `seconds`, one at least. With one rank: one.
std::uint64_t passes_of_interval(const IntervalLimits& limits);

}  // namespace sunfleck::engine
