// The least of a few sums of roots.
#include "render/balance_rule.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck {
namespace {

constexpr int kFewest = -4;  // powers of two of the usual number
constexpr int kMost = 2;
constexpr double kGreatest = 0x1p30;

double error_sum(std::span<const BlockVariance> blocks, const PassCost& cost, double paths) {
    double sum = 0;
    for (const BlockVariance& block : blocks) sum += std::sqrt(block.eye + block.photon / paths);
    return sum * std::sqrt(cost.eye + cost.photon * paths);
}

}  // namespace

std::uint32_t balanced_paths(std::span<const BlockVariance> blocks, const PassCost& cost,
                             std::uint32_t usual, double fewest, double before) {
    // Passes before are, like camera paths, what no number of photons to come changes.
    const PassCost work{(1 + before) * cost.eye + before * cost.photon * usual, cost.photon};
    std::vector<BlockVariance> variances;
    variances.reserve(blocks.size());
    for (const BlockVariance& block : blocks) {
        const double photon = std::max(0.0, block.photon);
        variances.push_back(
            {(1 + before) * std::max(0.0, block.eye) + before * photon / usual, photon});
    }
    double best = usual;
    double least = error_sum(variances, work, best);
    for (int power = kFewest; power <= kMost; ++power) {
        const double paths = std::floor(std::ldexp(usual, power));
        if (paths < fewest || paths > kGreatest) continue;
        const double error = error_sum(variances, work, paths);
        if (error < least) {
            least = error;
            best = paths;
        }
    }
    return static_cast<std::uint32_t>(best);
}

}  // namespace sunfleck
