// Bump maps by finite differences, normal maps by lookup.
#include "material/bump_map.h"

#include "image/lookup.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

struct Tangents {
    Vec3 u{0};
    Vec3 v{0};
};

struct PerturbedBy {
    const SurfaceDerivatives& surface;
    const Vec3d& origin;
    const Hit& hit;

    Tangents operator()(const std::monostate&) const { return {surface.dp_du, surface.dp_dv}; }

    Tangents operator()(const DisplacementMap& bumps) const {
        constexpr float kStep = 0.0005F;  // in u and v; pbrt-v4's value without a known footprint
        const TexturePoint here(hit, origin);
        const float height = bumps.displacement.at(here);
        const auto slope = [&](const Vec3& along, const Vec2& uv) {
            TexturePoint there = here;
            there.position += along * kStep;
            there.uv += uv * kStep;
            return hit.shading_normal * ((bumps.displacement.at(there) - height) / kStep);
        };
        return {surface.dp_du + slope(surface.dp_du, {1, 0}) + surface.dn_du * height,
                surface.dp_dv + slope(surface.dp_dv, {0, 1}) + surface.dn_dv * height};
    }

    Tangents operator()(const NormalMap& map) const {
        const Vec2 st = place(map.mapping, TexturePoint(hit, origin));
        const auto v = bilinear(*map.image, {st.x, 1 - st.y}, map.wraps);
        const bool grey = map.image->channels() == 1;
        const Frame frame(hit.shading_normal, surface.dp_du);
        const float side = map.follows_v && frame.y.dot(surface.dp_dv) < 0 ? -1.0F : 1.0F;
        const Vec3 local((2 * v[0] - 1) * map.strength,
                         (2 * v[grey ? 0 : 1] - 1) * (side * map.strength),
                         2 * v[grey ? 0 : 2] - 1);
        const Vec3 normal = frame.to_world(local).normalized();
        const Vec3 u = surface.dp_du - normal * normal.dot(surface.dp_du);
        return {u, normal.cross(u)};
    }
};

}  // namespace

void perturb_shading(const BumpMap& bump_map, const SurfaceDerivatives& surface, Hit& hit,
                     const Vec3d& origin) {
    const Tangents bent = std::visit(PerturbedBy{surface, origin, hit}, bump_map);
    const Vec3 normal = bent.u.cross(bent.v);
    const float length2 = normal.length2();
    if (!(length2 > 0) || !std::isfinite(length2)) return;
    const float side = normal.dot(hit.normal) < 0 ? -1.0F : 1.0F;
    hit.shading_normal = normal * (side / std::sqrt(length2));
    hit.tangent = bent.u;
}

}  // namespace sunfleck::engine
