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
double error_sum(const DrawMeasures& draw, double paths) {
    double sum = 0;
    for (const BlockVariance& block : draw.blocks)
        sum += std::sqrt(std::max(0.0, block.eye) + std::max(0.0, block.photon) / paths);
    return sum;
}

}  // namespace

double error_of_draws(const DrawMeasures& draw, double paths) {
    return error_sum(draw, paths) * std::sqrt(draw.cost.eye + draw.cost.photon * paths);
}

Balance balanced(const DrawMeasures& draw, std::uint32_t usual, double fewest) {
    double best = usual;
    double least = error_of_draws(draw, best);
    for (int power = kFewest; power <= kMost; ++power) {
        const double paths = std::floor(std::ldexp(usual, power));
        if (paths < fewest || paths > kGreatest) continue;
        const double error = error_of_draws(draw, paths);
        if (error < least) {
            least = error;
            best = paths;
        }
    }
    if (best >= usual) return {static_cast<std::uint32_t>(best), 1};
    const double worse = error_sum(draw, best) / error_sum(draw, usual);
    return {static_cast<std::uint32_t>(best),
            static_cast<std::uint32_t>(std::clamp(std::round(worse * worse), 1.0, kMostDraws))};
}

}  // namespace sunfleck
