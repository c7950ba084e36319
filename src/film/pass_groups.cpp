// Which groups of passes are evenly spread, and their shares.
#include "film/pass_groups.h"

#include "math/wavelengths.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

/// Indices in a batch at which groups begin and end.
constexpr std::array<std::uint64_t, 7> kEnds = {0, 1, 2, 4, 8, 12, kBatchPasses};
/// The same of the first batch, whose groups are early batches (batches.h).
constexpr std::array<std::uint64_t, 8> kEndsInFirst = {0, 1, 2, 4, 6, 8, 12, kBatchPasses};

/// Returns the range between two ends that holds an index.
template <std::size_t N>
PassRange range_around(std::uint64_t index, const std::array<std::uint64_t, N>& ends) {
    std::size_t end = 1;
    while (index >= ends[end]) ++end;
    return {ends[end - 1], ends[end]};
}

}  // namespace

PassRange smallest_group(std::uint64_t pass) {
    if (pass < kBatchPasses) return range_around(pass, kEndsInFirst);
    const std::uint64_t batch = pass / kBatchPasses * kBatchPasses;
    const PassRange within = range_around(pass - batch, kEnds);
    return {batch + within.begin, batch + within.end};
}

PassRange group_of(const PassSet& passes, std::uint64_t pass) {
    const std::uint64_t batch = pass / kBatchPasses * kBatchPasses;
    std::size_t next = 1;
    while (next < kEnds.size() && passes.count_in({batch, batch + kEnds[next]}) == kEnds[next])
        ++next;
    if (pass < batch + kEnds[next - 1]) return {batch, batch + kEnds[next - 1]};
    return smallest_group(pass);
}

std::vector<PassRange> open_groups(const PassSet& passes) {
    std::vector<PassRange> groups;
    for (const PassRange& range : passes.ranges())
        for (std::uint64_t pass = range.begin; pass < range.end;) {
            const PassRange group = group_of(passes, pass);
            const bool known = !groups.empty() && groups.back() == group;
            if (group.size() < kBatchPasses && !known) groups.push_back(group);
            pass = group.end;
            // Batches from here to the range's last are complete.
            if (pass % kBatchPasses == 0)
                pass = std::max(pass, range.end / kBatchPasses * kBatchPasses);
        }
    return groups;
}

double share_of_group(const PassSet& passes, const PassRange& group) {
    constexpr double kEnough = 8;
    if (passes.count_in(group) < group.size()) return 0;
    const double part = std::min(1.0, static_cast<double>(group.size()) / kEnough);
    return part * part;
}

}  // namespace sunfleck::engine
