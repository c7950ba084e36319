// Boxes of points, and steps of floats.
#include "import/pbrt/local_points.h"

#include <cmath>
#include <cstdio>

namespace sunfleck::engine {
namespace {

double largest_of(const Vec3d& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// Between floats of this size.
double float_step(double size) {
    int exponent = 0;
    std::frexp(size, &exponent);
    return std::ldexp(1.0, exponent - 24);
}

/// Were the points rounded to floats? Then all of them are floats, and some of the coordinates that
/// have that step are odd multiples of it; those of a mesh on whole numbers, say, are not.
bool are_rounded(const LocalPoints& local, std::span<const std::uint32_t> used, double step) {
    bool any_odd = false;
    for (const std::uint32_t i : used) {
        const Vec3d point = Vec3d(local.points[i]) + local.origin;
        if (Vec3d(Vec3(point)) != point) return false;
        for (int axis = 0; axis < 3; ++axis)
            any_odd |=
                float_step(point[axis]) == step && std::remainder(point[axis], 2 * step) != 0;
    }
    return any_odd;
}

}  // namespace

LocalPoints local_points(const std::vector<Vec3d>& points, std::span<const std::uint32_t> used) {
    Bounds box;
    for (const std::uint32_t i : used)
        if (i < points.size() && std::isfinite(largest_of(points[i]))) box.extend(points[i]);
    LocalPoints result;
    result.origin = origin_near(middle_of({box}));
    result.points.reserve(points.size());
    for (const Vec3d& p : points) result.points.emplace_back(p - result.origin);
    return result;
}

std::string coarseness_of(const LocalPoints& local,
                          const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    if (local.origin == Vec3d(0)) return {};
    double size = 0;
    double length = 0;
    std::size_t count = 0;
    for (const auto& corners : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d from(local.points[corners.at(k)]);
            size = std::max(size, largest_of(from + local.origin));
            const double edge = (Vec3d(local.points[corners.at((k + 1) % 3)]) - from).length();
            length += edge;
            count += edge > 0 ? 1 : 0;
        }
    const double step = float_step(size);
    if (count == 0 || !(step * 8 > length / static_cast<double>(count))) return {};
    if (!are_rounded(local, all_corners(triangles), step)) return {};
    std::array<char, 64> numbers{};
    std::snprintf(numbers.data(), numbers.size(), "%.2g, edges some %.2g", step,
                  length / static_cast<double>(count));
    return "the vertices stand so far from the origin that float numbers have steps of " +
           std::string(numbers.data()) +
           ": write them relative to a point near them, under a Translate, or as doubles";
}

}  // namespace sunfleck::engine
