// The least of a few sums of roots, and what a subpass is worth.
#include "planning/budget_allocation.h"

#include "film/film_sums.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kFewest = -4;  // powers of two of the usual number
constexpr int kMost = 2;
constexpr double kGreatest = 0x1p30;
constexpr double kMostSubpasses = 16;

}  // namespace

double error_of_subpass(const SubpassMeasures& subpass, double paths) {
    double sum = 0;
    for (const BlockVariance& block : subpass.blocks)
        sum += std::sqrt(std::max(0.0, block.camera) + std::max(0.0, block.photon) / paths);
    return sum;
}

double error_of_subpasses(const SubpassMeasures& subpass, double paths) {
    return error_of_subpass(subpass, paths) *
           std::sqrt(subpass.cost.camera + subpass.cost.photon * paths);
}

PhotonBudget allocated_budget(const SubpassMeasures& subpass, std::uint32_t usual, double fewest,
                              double of_pass) {
    double best = usual;
    double least = error_of_subpasses(subpass, best);
    for (int power = kFewest; power <= kMost; ++power) {
        const double paths = std::floor(std::ldexp(usual, power));
        if (paths < fewest || paths > kGreatest) continue;
        const double error = error_of_subpasses(subpass, paths);
        if (error < least) {
            least = error;
            best = paths;
        }
    }
    const double root = of_pass > 0 ? error_of_subpass(subpass, best) / of_pass : 1;
    const double worse = root > 0 ? root * root : 1;
    const auto whole = [](double x, double most) {
        return static_cast<std::uint32_t>(std::clamp(std::round(x), 1.0, most));
    };
    return {static_cast<std::uint32_t>(best), whole(worse, kMostSubpasses),
            whole(1 / worse, kMostWeight)};
}

}  // namespace sunfleck::engine
