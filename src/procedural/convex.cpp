// Facets: a large square in the plane, cut by one half-space after the other.

#include "procedural/convex.h"

#include "math/warp.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr double kLarge = 100;

/// What is left of a convex polygon (Sutherland and Hodgman 1974).
Polygon cut(const Polygon& polygon, const HalfSpace& by) {
    Polygon rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d& a = polygon[i];
        const Vec3d& b = polygon[(i + 1) % polygon.size()];
        const double beyond_a = by.normal.dot(a) - by.offset;
        const double beyond_b = by.normal.dot(b) - by.offset;
        if (beyond_a <= 0) rest.push_back(a);
        if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0))
            rest.push_back(a + (b - a) * (beyond_a / (beyond_a - beyond_b)));
    }
    return rest;
}

Polygon large_square(const HalfSpace& plane) {
    const Vec3d normal = plane.normal.normalized();
    const Vec3d foot = plane.normal * (plane.offset / plane.normal.dot(plane.normal));
    const Vec3d x = rotate_z_to(normal, {kLarge, 0, 0});
    const Vec3d y = rotate_z_to(normal, {0, kLarge, 0});
    return {foot - x - y, foot + x - y, foot + x + y, foot - x + y};
}

double rounded(double x) {
    return std::floor(x * 65536 + 0.5) / 65536;
}

}  // namespace

Polygon facet(const std::vector<HalfSpace>& half_spaces, std::size_t index) {
    Polygon polygon = large_square(half_spaces[index]);
    for (std::size_t i = 0; i < half_spaces.size(); ++i)
        if (i != index) polygon = cut(polygon, half_spaces[i]);
    Polygon corners;
    for (const Vec3d& p : polygon) {
        const Vec3d q(rounded(p.x), rounded(p.y), rounded(p.z));
        if (corners.empty() || (q != corners.back() && q != corners.front())) corners.push_back(q);
    }
    return corners.size() < 3 ? Polygon{} : corners;
}

void add_polygon(Mesh& mesh, const Polygon& polygon) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Vec3d& p : polygon)
        mesh.points.push_back(
            {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i)
        mesh.triangles.push_back({first, first + i, first + i + 1});
}

}  // namespace sunfleck::engine
