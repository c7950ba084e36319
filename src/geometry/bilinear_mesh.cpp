// Surfaces and areas of meshes of bilinear patches.
#include "geometry/bilinear_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

/// dP/ds of texture coordinates (s, t) that are bilinear in (u, v). Nothing where they have no
/// area.
Vec3d tangent_by(const std::array<Vec2, 4>& st, const Vec2d& uv, const Vec3d& du, const Vec3d& dv) {
    const auto at = [&](std::size_t i) { return Vec2d(st.at(i)); };
    const Vec2d by_u = (at(1) - at(0)) * (1 - uv.y) + (at(3) - at(2)) * uv.y;
    const Vec2d by_v = (at(2) - at(0)) * (1 - uv.x) + (at(3) - at(1)) * uv.x;
    const double determinant = by_u.x * by_v.y - by_u.y * by_v.x;
    if (determinant == 0) return Vec3d(0);
    return (du * by_v.y - dv * by_u.y) * (1 / determinant);
}

bool is_usable(const Vec3d& v) {
    const double length2 = v.dot(v);
    return length2 > 0 && std::isfinite(length2);
}

}  // namespace

LocalSurface BilinearPatch::at(const Vec3d& near, const Vec3d& direction) const {
    const Vec2d uv = surface.locate(near, direction);
    const Vec3d du = surface.du(uv.y);
    const Vec3d dv = surface.dv(uv.x);
    Vec3d normal = du.cross(dv);
    if (!is_usable(normal)) normal = surface.area_vector({0.5, 0.5});
    normal = is_usable(normal) ? normal.normalized() : Vec3d(0, 0, 1);
    Vec3d tangent = has_uvs ? tangent_by(uvs, uv, du, dv) : du;
    if (!is_usable(tangent))
        tangent = is_usable(du) ? du : normal.cross(Vec3d(normal.y, normal.z, -normal.x));
    LocalSurface result{surface.point(uv), normal, tangent, bilinear(uvs, uv)};
    result.given_normal = bilinear(normals, uv);
    return result;
}

BilinearPatch BilinearMesh::element(std::uint32_t patch) const {
    BilinearPatch result;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t vertex = patches[patch].at(i);
        if (vertex >= positions.size()) {
            result.surface.corner.fill(Vec3d(std::numeric_limits<double>::quiet_NaN()));
            return result;
        }
        result.surface.corner.at(i) = Vec3d(positions[vertex]);
        result.normals.at(i) = normals.empty() ? Vec3d(0) : Vec3d(normals[vertex]);
        if (!uvs.empty()) result.uvs.at(i) = uvs[vertex];
    }
    result.has_uvs = !uvs.empty();
    return result;
}

double BilinearMesh::area(const Affine& map) const {
    double sum = 0;
    for (std::uint32_t i = 0; i < count(); ++i) {
        const double one = element(i).surface.image(map).area();
        if (std::isfinite(one)) sum += one;
    }
    return sum;
}

}  // namespace sunfleck::engine
