// Maps from the unit square to discs, spheres, cones and triangles, in double.
//
// In:  u in (0,1)^2 (the closed square is allowed). Out: points whose density is uniform in area
// (or proportional to the cosine), by a map that is continuous and gentle, for Markov chains move
// in u: no map but those marked moves a point by more than 6.2 times its move in u, in
// units of the target's radius. Only + - * / sqrt: the same bits everywhere.
// Source: Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 1997); Clarberg,
// Fast Equal-Area Mapping of the (Hemi)Sphere (2008); Heitz, A Low-Distortion Map Between
// Triangle and Square (2019); Duff et al., Building an Orthonormal Basis, Revisited (JCGT 2017).
#pragma once

#include "math/trigonometry.h"
#include "math/vector.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

/// A point of the unit disc in polar form, for maps that stretch the radius.
struct DiscPoint {
    Vec2d position;
    double radius2 = 0;  // in [0,1], uniform
};

/// Uniform in the unit disc: concentric squares become concentric circles. Both ways are taken
/// by choosing numbers, for no processor could foresee which.
inline DiscPoint concentric_disc_point(const Vec2d& u) {
    const double a = 2 * u.x - 1;
    const double b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {Vec2d(0), 0};
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double other = wide ? b : a;
    const SinCos turn = sin_cos_small(other / radius * (kPiDouble / 4));
    const Vec2d unit(wide ? turn.cos : turn.sin, wide ? turn.sin : turn.cos);
    return {unit * radius, radius * radius};
}

/// Uniform in the unit disc. @return  x, y.
inline Vec2d concentric_disc(const Vec2d& u) {
    return concentric_disc_point(u).position;
}

/// Where concentric_disc() takes to a point of the disc: its inverse, within 1e-7.
inline Vec2d disc_to_square(const Vec2d& p) {
    const double radius = std::sqrt(p.x * p.x + p.y * p.y);
    if (!(radius > 0)) return Vec2d(0.5);
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double along = std::copysign(radius, wide ? p.x : p.y);
    const double turn = std::atan(static_cast<float>(wide ? p.y / p.x : p.x / p.y));
    const double across = along * std::clamp(turn / (kPiDouble / 4), -1.0, 1.0);
    return (Vec2d(wide ? along : across, wide ? across : along) + Vec2d(1)) / 2;
}

/// Uniform on the unit sphere, by equal-area octahedra: the square's inscribed diamond is the
/// upper hemisphere, its corners fold together at the lower pole.
inline Vec3d uniform_sphere(const Vec2d& u) {
    const double a = 2 * u.x - 1;
    const double b = 2 * u.y - 1;
    const double inside = 1 - (std::abs(a) + std::abs(b));  // sign of z
    const double radius = 1 - std::abs(inside);
    const double ratio = radius > 0 ? (std::abs(b) - std::abs(a)) / radius : 0;
    // Half the quadrant's diagonal lies at an eighth of a turn.
    const SinCos off = sin_cos_small(std::clamp(ratio, -1.0, 1.0) * (kPiDouble / 4));
    const double s = radius * std::sqrt(2 - radius * radius) * std::sqrt(0.5);
    return {std::copysign(s * (off.cos - off.sin), a), std::copysign(s * (off.cos + off.sin), b),
            std::copysign(1 - radius * radius, inside)};
}

/// Where uniform_sphere() takes to `w`: its inverse, within 1e-7. @param w  unit.
inline Vec2d sphere_to_square(const Vec3d& w) {
    const double flat2 = w.x * w.x + w.y * w.y;
    const double radius = std::sqrt(flat2 / (1 + std::abs(w.z)));
    const double x = std::abs(w.x);
    const double y = std::abs(w.y);
    const double tangent = x + y > 0 ? (y - x) / (y + x) : 0;
    const double off = std::atan(static_cast<float>(tangent));
    const double sum = w.z < 0 ? 2 - radius : radius;
    const double difference = radius * std::clamp(off / (kPiDouble / 4), -1.0, 1.0);
    return {(1 + std::copysign((sum - difference) / 2, w.x)) / 2,
            (1 + std::copysign((sum + difference) / 2, w.y)) / 2};
}

/// A direction around +z whose 1 - cos is `versine` and whose azimuth is that of a disc point.
/// The disc's radius2 must be monotone in `versine` for the map to be continuous.
inline Vec3d around_pole(const DiscPoint& disc, double versine) {
    if (!(disc.radius2 > 0)) return {0, 0, 1};
    const double stretch = std::sqrt(versine * (2 - versine) / disc.radius2);
    return {disc.position.x * stretch, disc.position.y * stretch, 1 - versine};
}

/// Around +z with density cos / pi. Steep at the horizon: height^2 is gentle there, not height.
inline Vec3d cosine_hemisphere(const Vec2d& u) {
    const DiscPoint disc = concentric_disc_point(u);
    return {disc.position.x, disc.position.y, std::sqrt(std::max(0.0, 1 - disc.radius2))};
}

/// Uniform in the triangle (0,0), (1,0), (0,1): the weights of its second and third corner.
inline Vec2d uniform_triangle(const Vec2d& u) {
    if (u.y > u.x) return {u.x * 0.5, u.y - u.x * 0.5};
    return {u.x - u.y * 0.5, u.y * 0.5};
}

/// Where uniform_triangle() takes to the weights of the second and third corner: its inverse.
inline Vec2d triangle_to_square(const Vec2d& weight) {
    const double sum = weight.x + weight.y;
    return weight.y > weight.x ? Vec2d(2 * weight.x, sum) : Vec2d(sum, 2 * weight.y);
}

/// The rotation that takes +z to `axis` on the shortest way, applied to `local`: continuous in
/// both but at axis = -z, around which the frame turns twice.
/// @param axis  unit.
inline Vec3d rotate_z_to(const Vec3d& axis, const Vec3d& local) {
    const double flat2 = axis.x * axis.x + axis.y * axis.y;
    const double above = axis.z > 0 ? 1 + axis.z : flat2 / (1 - axis.z);  // 1 + z, all digits
    if (!(above > 0)) return {local.x, -local.y, -local.z};
    const double flat = axis.x * local.x + axis.y * local.y;
    const double along = local.z - flat / above;
    return {local.x + axis.x * along, local.y + axis.y * along, axis.z * local.z - flat};
}

/// The inverse of rotate_z_to(): takes `axis` to +z.
inline Vec3d rotate_to_z(const Vec3d& axis, const Vec3d& world) {
    return rotate_z_to({-axis.x, -axis.y, axis.z}, world);
}

}  // namespace sunfleck::engine
