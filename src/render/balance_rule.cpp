// The least of a few sums of roots.
#include "render/balance_rule.h"

#include <algorithm>
#include <cmath>

namespace sunfleck {
namespace {

constexpr int kFewest = -4;  // powers of two of the usual number
constexpr int kMost = 2;
constexpr double kGreatest = 0x1p30;

/// Of passes with some number of paths, and of those before.
struct Passes {
    double paths;
    double usual;
    double before;
};

double error_sum(std::span<const BlockVariance> blocks, const PassCost& cost,
                 const Passes& passes) {
    const double more = 1 + passes.before;
    const double photon_share = 1 / passes.paths + passes.before / passes.usual;
    double sum = 0;
    for (const BlockVariance& block : blocks)
        sum +=
            std::sqrt(more * std::max(0.0, block.eye) + photon_share * std::max(0.0, block.photon));
    return sum *
           std::sqrt(more * cost.eye + cost.photon * (passes.paths + passes.before * passes.usual));
}

}  // namespace

std::uint32_t balanced_paths(std::span<const BlockVariance> blocks, const PassCost& cost,
                             std::uint32_t usual, double fewest, double before) {
    double best = usual;
    double least = error_sum(blocks, cost, {best, best, before});
    for (int power = kFewest; power <= kMost; ++power) {
        const double paths = std::floor(std::ldexp(usual, power));
        if (paths < fewest || paths > kGreatest) continue;
        const double error = error_sum(blocks, cost, {paths, static_cast<double>(usual), before});
        if (error < least) {
            least = error;
            best = paths;
        }
    }
    return static_cast<std::uint32_t>(best);
}

}  // namespace sunfleck
