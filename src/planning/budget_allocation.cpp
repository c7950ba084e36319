// The least of a few sums of roots, and what a draw is worth.
#include "planning/budget_allocation.h"

#include "film/film_sums.h"

#include <algorithm>
#include <cmath>

namespace sunfleck {
namespace {

constexpr int kFewest = -4;  // powers of two of the usual number
constexpr int kMost = 2;
constexpr double kGreatest = 0x1p30;
constexpr double kMostDraws = 16;

}  // namespace

double error_of_draw(const DrawMeasures& draw, double paths) {
    double sum = 0;
    for (const BlockVariance& block : draw.blocks)
        sum += std::sqrt(std::max(0.0, block.eye) + std::max(0.0, block.photon) / paths);
    return sum;
}

double error_of_draws(const DrawMeasures& draw, double paths) {
    return error_of_draw(draw, paths) * std::sqrt(draw.cost.eye + draw.cost.photon * paths);
}

Balance balanced(const DrawMeasures& draw, std::uint32_t usual, double fewest, double of_pass) {
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
    const double root = of_pass > 0 ? error_of_draw(draw, best) / of_pass : 1;
    const double worse = root > 0 ? root * root : 1;
    const auto whole = [](double x, double most) {
        return static_cast<std::uint32_t>(std::clamp(std::round(x), 1.0, most));
    };
    return {static_cast<std::uint32_t>(best), whole(worse, kMostDraws),
            whole(1 / worse, kMostWeight)};
}

}  // namespace sunfleck
