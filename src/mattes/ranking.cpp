// Runs of equal IDs, then the longest first.
#include "mattes/ranking.h"

#include <algorithm>

namespace sunfleck::engine {

std::vector<RankedId> ranked_ids(std::vector<MatteId>& samples) {
    std::sort(samples.begin(), samples.end());
    std::vector<RankedId> ranked;
    for (const MatteId id : samples) {
        if (id == kNoMatteId) continue;
        if (ranked.empty() || ranked.back().id != id) ranked.push_back({id, 0});
        ++ranked.back().count;
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const RankedId& a, const RankedId& b) { return a.count > b.count; });
    return ranked;
}

}  // namespace sunfleck::engine
