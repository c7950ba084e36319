// Areas of placed shapes.
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace sunfleck::engine {
namespace {

double mesh_area(const TriangleMesh& mesh, const Affine& to_world) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& corners = mesh.triangles[i];
        if (*std::max_element(corners.begin(), corners.end()) >= mesh.positions.size()) continue;
        const double area = placed_triangle(mesh, to_world, i).area();
        if (std::isfinite(area)) sum += area;
    }
    return sum;
}

Bounds own_bounds(const TriangleMesh& mesh) {
    Bounds box;
    for (const auto& corners : mesh.triangles)
        for (const std::uint32_t corner : corners)
            if (corner < mesh.positions.size()) box.extend(Vec3d(mesh.positions[corner]));
    return box;
}

}  // namespace

Triangle placed_triangle(const TriangleMesh& mesh, const Affine& to_world, std::size_t triangle) {
    const auto& c = mesh.triangles[triangle];
    const auto corner = [&](std::uint32_t i) {
        return Vec3d(placed_vertex(mesh.positions[i], to_world));
    };
    return {{corner(c[0]), corner(c[1]), corner(c[2])}};
}

Bounds image_of(const Bounds& box, const Affine& map) {
    Bounds result;
    if (box.is_empty()) return result;
    const std::array<Vec3d, 2> ends{box.min, box.max};
    for (unsigned i = 0; i < 8; ++i)
        result.extend(
            map.point({ends.at(i & 1U).x, ends.at((i >> 1U) & 1U).y, ends.at((i >> 2U) & 1U).z}));
    return result;
}

Bounds bounds_of(const PlacedShape& placed) {
    const Affine map(placed.to_world);
    return std::visit(
        [&](const auto& shape) {
            using S = std::decay_t<decltype(shape)>;
            Bounds box;
            if constexpr (std::is_same_v<S, TriangleMesh>) return image_of(own_bounds(shape), map);
            const auto bounds = [&](const auto& surface) { return surface.bounds(map); };
            for (std::uint32_t i = 0; i < exact_count(shape); ++i)
                box.extend(with_exact(shape, i, bounds, Bounds()));
            return box;
        },
        placed.shape);
}

double surface_area(const PlacedShape& placed) {
    const Affine to_world(placed.to_world);
    return std::visit(
        [&](const auto& shape) {
            using S = std::decay_t<decltype(shape)>;
            if constexpr (HasArea<S>)
                return shape.area(to_world);
            else if constexpr (std::is_same_v<S, TriangleMesh>)
                return mesh_area(shape, to_world);
            else
                return 0.0;
        },
        placed.shape);
}

}  // namespace sunfleck::engine
