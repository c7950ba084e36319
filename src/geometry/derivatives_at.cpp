// Derivatives by the triangle's own plane and normals, or by the exact shape.
//
// Source: Pharr, Jakob, Humphreys, Physically Based Rendering, 4th edition, section 6.5.3.
#include "geometry/derivatives_at.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

/// The linear map from uv to some quantity, by its values at the corners.
struct Slopes {
    Vec3d du{0};
    Vec3d dv{0};
    bool exist = false;

    Slopes(const std::array<Vec3d, 3>& value, const std::array<Vec2, 3>& uv) {
        const Vec2d a = Vec2d(uv[0]) - Vec2d(uv[2]);
        const Vec2d b = Vec2d(uv[1]) - Vec2d(uv[2]);
        const double determinant = a.x * b.y - a.y * b.x;
        const Vec3d first = value[0] - value[2];
        const Vec3d second = value[1] - value[2];
        du = (first * b.y - second * a.y) * (1 / determinant);
        dv = (second * a.x - first * b.x) * (1 / determinant);
        const double size = du.length2() + dv.length2();
        exist = std::isfinite(size);
    }
};

SurfaceDerivatives in_world(const BuiltInstance* instance, SurfaceDerivatives d) {
    if (instance == nullptr) return d;
    const Placement& placement = instance->placement;
    const auto along = [&](const Vec3& v) { return Vec3(placement.to_world.vector(Vec3d(v))); };
    const auto across = [&](const Vec3& n) { return Vec3(placement.normal(Vec3d(n))); };
    return {along(d.dp_du), along(d.dp_dv), across(d.dn_du), across(d.dn_dv)};
}

SurfaceDerivatives of_triangle(const BuiltShape& shape, std::uint32_t primitive,
                               const BuiltInstance* instance) {
    const TriangleMesh& mesh = *shape.mesh();
    const BuiltShape::Corners& c = shape.corners(primitive);
    std::array<Vec2, 3> uv{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
    if (!mesh.uvs.empty()) uv = {mesh.uvs[c[0]], mesh.uvs[c[1]], mesh.uvs[c[2]]};
    SurfaceDerivatives d;
    const Slopes position(shape.triangle(primitive).corner, uv);
    if (position.exist) {
        d.dp_du = Vec3(position.du);
        d.dp_dv = Vec3(position.dv);
    }
    if (!mesh.normals.empty()) {
        std::array<Vec3d, 3> normals;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d placed = shape.placement().normal(Vec3d(mesh.normals[c.at(i)]));
            normals.at(i) = placed.normalized() * (shape.flip() ? -1.0 : 1.0);
        }
        const Slopes normal(normals, uv);
        if (normal.exist) {
            d.dn_du = Vec3(normal.du);
            d.dn_dv = Vec3(normal.dv);
        }
    }
    return in_world(instance, d);
}

SurfaceDerivatives of_exact_shape(const BuiltShape& shape, const BuiltInstance* instance,
                                  const Hit& hit) {
    const Vec3d p(hit.position);
    const Vec3d in_group = instance == nullptr ? p : instance->placement.to_object.point(p);
    const Vec3d local = shape.placement().to_object.point(in_group);
    // Along the normal: what turns with the ray shows this side then.
    Vec3d inwards(-hit.normal);
    if (instance != nullptr) inwards = instance->placement.to_object.vector(inwards);
    inwards = shape.placement().to_object.vector(inwards);
    const auto around = [&](const auto& s) { return s.at(local, inwards); };
    const LocalSurface surface = std::visit(
        [&](const auto& s) { return with_exact(s, hit.primitive, around, LocalSurface()); },
        shape.shape());
    const Affine& map = shape.placement().to_world;
    SurfaceDerivatives d;
    d.dp_du = Vec3(map.vector(surface.tangent));
    d.dp_dv = Vec3(map.vector(surface.cotangent));
    return in_world(instance, d);
}

}  // namespace

SurfaceDerivatives derivatives_at(const BuiltShape& shape, const BuiltInstance* instance,
                                  const Hit& hit) {
    const TriangleMesh* mesh = shape.mesh();
    SurfaceDerivatives d = mesh != nullptr ? of_triangle(shape, hit.primitive, instance)
                                           : of_exact_shape(shape, instance, hit);
    const bool bent = mesh != nullptr && !(mesh->normals.empty() && mesh->tangents.empty());
    const bool flat = !(d.dp_du.cross(d.dp_dv).length2() > 0);
    if (!bent && !flat) return d;
    // Hit::tangent is the given tangent, or dp/du.
    const Vec3 across = hit.shading_normal.cross(hit.tangent);
    if (across.length2() > 0) {
        d.dp_du = across.cross(hit.shading_normal);
        d.dp_dv = across;
    } else {
        const Frame frame(hit.shading_normal);
        d.dp_du = frame.x;
        d.dp_dv = frame.y;
    }
    return d;
}

}  // namespace sunfleck::engine
