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
constexpr double kLater = 3;  // passes of a render, over those of the first epoch

double variance_of(const BlockVariance& block, double paths) {
    return std::max(0.0, block.eye) + std::max(0.0, block.photon) / paths;
}

double work_of(const DrawCost& cost, double paths) {
    return cost.eye + cost.photon * paths;
}

/// Of all blocks, in one draw.
double error_sum(const DrawMeasures& draw, double paths) {
    double sum = 0;
    for (const BlockVariance& block : draw.blocks) sum += std::sqrt(variance_of(block, paths));
    return sum;
}

}  // namespace

Balance balanced(const DrawMeasures& draw, std::uint32_t usual, double fewest,
                 const DrawMeasures* worth) {
    const auto error_after_work = [&](double paths) {
        return error_sum(draw, paths) * std::sqrt(work_of(draw.cost, paths));
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
    const double worse = error_sum(draw, best) / error_sum(worth == nullptr ? draw : *worth, usual);
    return {static_cast<std::uint32_t>(best),
            static_cast<std::uint32_t>(std::clamp(std::round(worse * worse), 1.0, kMostDraws))};
}

double error_of_render(const DrawMeasures& usual, std::uint32_t usual_paths,
                       const DrawMeasures& draw, const Balance& balance) {
    double sum = 0;
    for (std::size_t b = 0; b < draw.blocks.size(); ++b)
        sum += std::sqrt(variance_of(usual.blocks[b], usual_paths) +
                         kLater * variance_of(draw.blocks[b], balance.paths) / balance.draws);
    return sum * std::sqrt(work_of(usual.cost, usual_paths) +
                           kLater * balance.draws * work_of(draw.cost, balance.paths));
}

}  // namespace sunfleck
