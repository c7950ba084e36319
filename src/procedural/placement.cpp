// Placements, and meshes carried by them.

#include "procedural/placement.h"

#include "math/trigonometry.h"

namespace sunfleck::engine {

std::array<float, 3> rounded_point(const Vec3d& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

Placement at(const Vec3d& origin) {
    return {.origin = origin};
}

Placement turned(double turns, const Vec3d& origin) {
    const SinCos t = sin_cos_2pi(turns);
    return {.x = {t.cos, t.sin, 0}, .y = {-t.sin, t.cos, 0}, .origin = origin};
}

Placement tilted(double turns, const Vec3d& origin) {
    const SinCos t = sin_cos_2pi(turns);
    return {.y = {0, t.cos, t.sin}, .z = {0, -t.sin, t.cos}, .origin = origin};
}

Placement standing(double turns, const Vec3d& origin) {
    return turned(turns, origin) * tilted(0.25, Vec3d(0));
}

Placement operator*(const Placement& outer, const Placement& inner) {
    const auto direction = [&](const Vec3d& v) { return outer(v) - outer.origin; };
    return {direction(inner.x), direction(inner.y), direction(inner.z), outer(inner.origin)};
}

Mesh placed(Mesh mesh, const Placement& placement) {
    for (auto& p : mesh.points) p = rounded_point(placement({p[0], p[1], p[2]}));
    for (auto& n : mesh.normals)
        n = rounded_point(placement({n[0], n[1], n[2]}) - placement.origin);
    return mesh;
}

}  // namespace sunfleck::engine
