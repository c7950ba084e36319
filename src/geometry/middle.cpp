// Medians of boxes, and rounding to the grid.
#include "geometry/middle.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

/// The upper one of two. @param values  not empty; their order changes.
double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Middle middle_of(const std::vector<Bounds>& boxes) {
    Middle result;
    std::vector<double> values;
    const auto median_of = [&](const auto& value) {
        values.clear();
        for (const Bounds& box : boxes)
            if (!box.is_empty()) values.push_back(value(box));
        return values.empty() ? 0 : median(values);
    };
    for (int axis = 0; axis < 3; ++axis)
        result.center[axis] = median_of([&](const Bounds& box) { return box.center()[axis]; });
    result.radius = median_of(
        [&](const Bounds& box) { return (box.center() - result.center).length() + box.radius(); });
    return result;
}

Vec3d origin_near(const Middle& middle) {
    constexpr double kNear = 32;
    const Vec3d& c = middle.center;
    const double farthest = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
    if (!(middle.radius > 0) || !(farthest > kNear * middle.radius)) return Vec3d(0);
    int exponent = 0;
    std::frexp(middle.radius, &exponent);
    const double step = std::ldexp(1.0, exponent);
    return {std::round(c.x / step) * step, std::round(c.y / step) * step,
            std::round(c.z / step) * step};
}

}  // namespace sunfleck::engine
