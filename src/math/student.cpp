// Quantiles by numerical integration: with t = sqrt(n) tan(x) the density of n degrees is
// proportional to cos(x)^(n - 1), a bounded function on a bounded interval, integrated by
// trapezoids.
#include "math/student.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace sunfleck::engine {

double student_quantile(double within, double degrees) {
    constexpr std::size_t kSteps = 4096;
    constexpr double kMostDegrees = 1e4;
    constexpr double kStep = std::numbers::pi / 2 / kSteps;
    const double n = std::min(degrees, kMostDegrees);
    std::array<double, kSteps + 1> below{};
    double density = 1;
    for (std::size_t i = 1; i <= kSteps; ++i) {
        const double next = std::pow(std::cos(static_cast<double>(i) * kStep), n - 1);
        below.at(i) = below.at(i - 1) + 0.5 * (density + next);
        density = next;
    }
    const double wanted = within * below.back();
    const auto end = static_cast<std::size_t>(
        std::distance(below.begin(), std::upper_bound(below.begin() + 1, below.end() - 1, wanted)));
    const double start = below.at(end - 1);
    const double x = static_cast<double>(end - 1) + (wanted - start) / (below.at(end) - start);
    return std::sqrt(n) * std::tan(x * kStep);
}

}  // namespace sunfleck::engine
