// The least of a few sums of roots, and what a draw is worth.
#include "render/balance_rule.h"

#include <algorithm>
#include <cmath>

namespace sunfleck {
namespace {

constexpr int kFewest = -4;  // powers of two of the usual number
constexpr int kMost = 2;
constexpr double kGreatest = 0x1p30;
constexpr double kMostDraws = 16;

/// Of all blocks, in one draw.
double error_sum(std::span<const BlockVariance> blocks, double paths) {
    double sum = 0;
    for (const BlockVariance& block : blocks)
        sum += std::sqrt(std::max(0.0, block.eye) + std::max(0.0, block.photon) / paths);
    return sum;
}

}  // namespace

Balance balanced(std::span<const BlockVariance> blocks, const DrawCost& cost, std::uint32_t usual,
                 double fewest) {
    const auto error_after_work = [&](double paths) {
        return error_sum(blocks, paths) * std::sqrt(cost.eye + cost.photon * paths);
    };
    double best = usual;
    double least = error_after_work(best);
    for (int power = kFewest; power <= kMost; ++power) {
        const double paths = std::floor(std::ldexp(usual, power));
        if (paths < fewest || paths > kGreatest) continue;
        const double error = error_after_work(paths);
        if (error < least) {
            least = error;
            best = paths;
        }
    }
    if (best >= usual) return {static_cast<std::uint32_t>(best), 1};
    const double worse = error_sum(blocks, best) / error_sum(blocks, usual);
    return {static_cast<std::uint32_t>(best),
            static_cast<std::uint32_t>(std::clamp(std::round(worse * worse), 1.0, kMostDraws))};
}

}  // namespace sunfleck
