// Barycentrics, bilinear coordinates, and those of quadrics.
#include "light/surface_uv.h"

namespace sunfleck::engine {
namespace {

Vec2 uv_of(const EmittingTriangle& t, const CornerUvs& uvs, const Vec3d& on, const Vec3d&) {
    const Vec3d area = t.edge1.cross(t.edge2);
    const Vec3d from = on - t.p0;
    const double area2 = area.length2();
    if (!(area2 > 0)) return uvs[0];
    const auto second = static_cast<float>(from.cross(t.edge2).dot(area) / area2);
    const auto third = static_cast<float>(t.edge1.cross(from).dot(area) / area2);
    return uvs[0] + (uvs[1] - uvs[0]) * second + (uvs[2] - uvs[0]) * third;
}

Vec2 uv_of(const EmittingPatch& patch, const CornerUvs& uvs, const Vec3d& on, const Vec3d& normal) {
    return bilinear(uvs, patch.surface.locate(on, normal));
}

template <class Quadric>
Vec2 uv_of(const EmittingQuadric<Quadric>& quadric, const CornerUvs&, const Vec3d& on,
           const Vec3d& normal) {
    return quadric.shape.at(Affine(quadric.to_world).inverse().point(on), normal).uv;
}

}  // namespace

bool has_corners(const EmittingSurface& surface) {
    return std::holds_alternative<EmittingTriangle>(surface) ||
           std::holds_alternative<EmittingPatch>(surface);
}

Vec2 uv_at(const EmittingSurface& surface, const CornerUvs& uvs, const Vec3d& on,
           const Vec3d& normal) {
    return std::visit([&](const auto& s) { return uv_of(s, uvs, on, normal); }, surface);
}

}  // namespace sunfleck::engine
