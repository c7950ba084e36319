// Surfaces out of range, with a quick answer for meshes that are far within it.
#include "geometry/extent.h"

#include "geometry/measure.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns an upper bound of the absolute coordinates of all vertices; NaN and infinity count as
/// infinity.
double bound_of(const TriangleMesh& mesh, const Affine& to_world) {
    float most = 0;
    for (const Vec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(p[axis]) <= most))
                most = std::isfinite(p[axis]) ? std::abs(p[axis]) : kInfinity;
    const Vec3d one(1);
    return most * (absolute_dot(to_world.x, one) + absolute_dot(to_world.y, one) +
                   absolute_dot(to_world.z, one)) +
           absolute_dot(to_world.origin, one);
}

std::size_t count_in(const TriangleMesh& mesh, const Affine& to_world) {
    if (9 * bound_of(mesh, to_world) < kLargestExtent) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& corners = mesh.triangles[i];
        if (*std::max_element(corners.begin(), corners.end()) >= mesh.positions.size()) continue;
        if (!is_in_range(placed_triangle(mesh, to_world, i))) ++count;
    }
    return count;
}

template <class S>
std::size_t count_in(const S& shape, const Affine& to_world) {
    const auto bounds = [&](const auto& surface) { return surface.bounds(to_world); };
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < exact_count(shape); ++i) {
        const Bounds box = with_exact(shape, i, bounds, Bounds());
        if (!box.is_empty() && !is_in_range(box)) ++count;
    }
    return count;
}

}  // namespace

std::size_t count_out_of_range(const PlacedShape& placed) {
    const Affine to_world(placed.to_world);
    return std::visit([&](const auto& shape) { return count_in(shape, to_world); }, placed.shape);
}

}  // namespace sunfleck::engine
