// Areas of placed shapes.
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace sunfleck {
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

}  // namespace

Triangle placed_triangle(const TriangleMesh& mesh, const Affine& to_world, std::size_t triangle) {
    const auto& c = mesh.triangles[triangle];
    const auto corner = [&](std::uint32_t i) {
        return Vec3d(placed_vertex(mesh.positions[i], to_world));
    };
    return {{corner(c[0]), corner(c[1]), corner(c[2])}};
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

}  // namespace sunfleck
