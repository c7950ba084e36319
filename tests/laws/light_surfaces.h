// Where a ray meets an emitting surface, by textbook formulas in double: the light laws' own
// truth about the shapes, independent of how lights are sampled.
#pragma once

#include "light/area_light.h"

#include <cmath>
#include <vector>

namespace sunfleck::engine::testing_support {

struct SurfaceHit {
    Vec3d position;
    Vec3d normal;  // unit, as Hit::normal would be
};

inline bool within_sweep(double x, double y, double phi_max) {
    const double phi = std::atan2(y, x);
    return (phi < 0 ? phi + 2 * kPiDouble : phi) <= phi_max;
}

inline std::vector<SurfaceHit> surface_hits(const EmittingTriangle& t, const Vec3d& origin,
                                            const Vec3d& direction) {
    const Vec3d across = direction.cross(t.edge2);
    const double determinant = t.edge1.dot(across);
    const Vec3d from = origin - t.p0;
    const double u = from.dot(across) / determinant;
    const double v = direction.dot(from.cross(t.edge1)) / determinant;
    const double distance = t.edge2.dot(from.cross(t.edge1)) / determinant;
    if (!(distance > 0 && u >= 0 && v >= 0 && u + v <= 1)) return {};
    return {{origin + direction * distance, t.normal}};
}

/// Distances along a line in the shape's own frame, and the normal at a point there.
inline std::vector<double> own_roots(const Sphere& s, const Vec3d& o, const Vec3d& d) {
    const double half = o.dot(d) / d.length2();
    const double rest = half * half - (o.length2() - s.radius * s.radius) / d.length2();
    if (rest < 0) return {};
    return {-half - std::sqrt(rest), -half + std::sqrt(rest)};
}
inline bool own_part(const Sphere& s, const Vec3d& p) {
    return p.z >= s.z_min && p.z <= s.z_max && within_sweep(p.x, p.y, s.phi_max);
}
inline Vec3d own_normal(const Sphere&, const Vec3d& p) {
    return p;
}

inline std::vector<double> own_roots(const Disk& disk, const Vec3d& o, const Vec3d& d) {
    return {(disk.height - o.z) / d.z};
}
inline bool own_part(const Disk& disk, const Vec3d& p) {
    const double r = std::hypot(p.x, p.y);
    return r >= disk.inner_radius && r <= disk.radius && within_sweep(p.x, p.y, disk.phi_max);
}
inline Vec3d own_normal(const Disk&, const Vec3d&) {
    return {0, 0, 1};
}

inline std::vector<double> own_roots(const Cylinder& c, const Vec3d& o, const Vec3d& d) {
    const double a = d.x * d.x + d.y * d.y;
    const double half = (o.x * d.x + o.y * d.y) / a;
    const double rest = half * half - (o.x * o.x + o.y * o.y - c.radius * c.radius) / a;
    if (rest < 0) return {};
    return {-half - std::sqrt(rest), -half + std::sqrt(rest)};
}
inline bool own_part(const Cylinder& c, const Vec3d& p) {
    return p.z >= c.z_min && p.z <= c.z_max && within_sweep(p.x, p.y, c.phi_max);
}
inline Vec3d own_normal(const Cylinder&, const Vec3d& p) {
    return {p.x, p.y, 0};
}

/// In the frame of the line, its x and y put to zero: two equations, bilinear in u and v. Their
/// resultant is a quadratic in v.
inline std::vector<SurfaceHit> surface_hits(const EmittingPatch& patch, const Vec3d& origin,
                                            const Vec3d& direction) {
    const Vec3d z = direction.normalized();
    const Vec3d x = z.cross(std::abs(z.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0)).normalized();
    const Vec3d y = z.cross(x);
    std::array<Vec3d, 4> c;  // of 1, u, v, uv
    const auto& p = patch.surface.corner;
    const std::array<Vec3d, 4> terms{p[0] - origin, p[1] - p[0], p[2] - p[0],
                                     p[3] - p[1] - p[2] + p[0]};
    for (std::size_t i = 0; i < 4; ++i) c.at(i) = {terms.at(i).dot(x), terms.at(i).dot(y), 0};
    const auto cross = [&](std::size_t i, std::size_t j) {
        return c.at(i).x * c.at(j).y - c.at(i).y * c.at(j).x;
    };
    // (c0 + v c2) x (c1 + v c3) = 0
    const double a = cross(2, 3);
    const double b = cross(0, 3) + cross(2, 1);
    const double e = cross(0, 1);
    std::vector<double> roots;
    if (std::abs(a) < 1e-9) {
        roots = {-e / b};
    } else if (b * b >= 4 * a * e) {
        const double root = std::sqrt(b * b - 4 * a * e);
        roots = {(-b - root) / (2 * a), (-b + root) / (2 * a)};
    }
    std::vector<SurfaceHit> hits;
    for (const double v : roots) {
        const Vec3d start = c[0] + c[2] * v;
        const Vec3d step = c[1] + c[3] * v;
        const double u = -start.dot(step) / step.length2();
        if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) continue;
        const Vec3d at = p[0] + terms[1] * u + terms[2] * v + terms[3] * (u * v);
        if (!((at - origin).dot(direction) > 0)) continue;
        Vec3d normal = (terms[1] + terms[3] * v).cross(terms[2] + terms[3] * u).normalized();
        if (patch.flip) normal = -normal;
        const auto& n = patch.normals;
        const Vec3d given = n[0] * ((1 - u) * (1 - v)) + n[1] * (u * (1 - v)) +
                            n[2] * ((1 - u) * v) + n[3] * (u * v);
        hits.push_back({at, normal.dot(given) < 0 ? -normal : normal});
    }
    return hits;
}

template <class Quadric>
std::vector<SurfaceHit> surface_hits(const EmittingQuadric<Quadric>& surface, const Vec3d& origin,
                                     const Vec3d& direction) {
    const Matrix inverse = surface.to_world.inverse();
    const Vec3d o = origin * inverse;
    Vec3d d;
    inverse.multDirMatrix(direction, d);
    std::vector<SurfaceHit> hits;
    for (const double t : own_roots(surface.shape, o, d)) {
        const Vec3d p = o + d * t;
        if (!(t > 0) || !own_part(surface.shape, p)) continue;
        Vec3d normal;  // by the inverse transposed
        inverse.transposed().multDirMatrix(own_normal(surface.shape, p), normal);
        hits.push_back({p * surface.to_world, normal.normalized() * (surface.flip ? -1 : 1)});
    }
    return hits;
}

/// The points of the light that the ray meets and that emit towards its origin, whatever of the
/// light stands in between.
inline std::vector<SurfaceHit> emitting_hits(const AreaLight& light, const Vec3d& origin,
                                             const Vec3d& direction) {
    const auto all = [&](const auto& s) { return surface_hits(s, origin, direction); };
    std::vector<SurfaceHit> hits;
    for (const SurfaceHit& hit : std::visit(all, light.surface))
        if (light.two_sided || hit.normal.dot(direction) < 0) hits.push_back(hit);
    return hits;
}

}  // namespace sunfleck::engine::testing_support
