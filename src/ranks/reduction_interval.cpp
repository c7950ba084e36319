// Division of passes among ranks.
#include "ranks/reduction_interval.h"

#include "film/batches.h"
#include "math/wavelengths.h"

#include <algorithm>

namespace sunfleck::engine {

PassRange block_of(const PassRange& interval, int rank, int size) {
    const auto r = static_cast<std::uint64_t>(rank);
    const auto ranks = static_cast<std::uint64_t>(size);
    return {interval.begin + interval.size() * r / ranks,
            interval.begin + interval.size() * (r + 1) / ranks};
}

std::vector<PassRange> cut_at_batches(const PassRange& interval) {
    std::vector<PassRange> parts;
    for (std::uint64_t begin = interval.begin; begin < interval.end; begin = parts.back().end) {
        parts.push_back({begin, std::min(interval.end, next_batch_end(begin))});
    }
    return parts;
}

PassRange common(const PassRange& a, const PassRange& b) {
    const std::uint64_t begin = std::max(a.begin, b.begin);
    return {begin, std::max(begin, std::min(a.end, b.end))};
}

std::uint64_t passes_of_interval(const IntervalLimits& limits) {
    constexpr double kMost = 1 << 20;  // per rank; far beyond any use
    if (limits.ranks == 1) return 1;
    const auto ranks = static_cast<std::uint64_t>(limits.ranks);
    std::uint64_t each = 1;
    if (limits.pass_seconds > 0) {
        const double wanted = std::min(limits.seconds / limits.pass_seconds, kMost);
        each = static_cast<std::uint64_t>(std::max(1.0, wanted));
    }
    if (limits.batches) each = std::min(each, std::max<std::uint64_t>(1, kBatchPasses / ranks));
    const std::uint64_t passes = each * ranks;
    return limits.at_most ? std::min(passes, *limits.at_most) : passes;
}

}  // namespace sunfleck::engine
