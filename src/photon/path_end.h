// How photon paths end.
#pragma once

#include "aovs/statistics.h"

namespace sunfleck::engine {

enum class PathEnd {
    no_light,  // no emission at that sample
    escaped,   // left the scene
    absorbed,  // by a surface, a medium, or Russian roulette
    too_long   // the next event would exceed the maximum depth
};

/// Counts how a path ended.
inline void count_end(PathEnd end, Statistics& counts) {
    counts[Count::escaped] += end == PathEnd::escaped ? 1 : 0;
    counts[Count::too_long] += end == PathEnd::too_long ? 1 : 0;
}

}  // namespace sunfleck::engine
