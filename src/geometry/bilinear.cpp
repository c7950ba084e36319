// Intersection and area of bilinear patches.
#include "geometry/bilinear.h"

#include "geometry/quadrature.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// u and v this far outside belong to the patch, so that rounding leaves no gap between patches.
constexpr double kSlack = 0x1p-44;

struct Roots {
    std::array<double, 2> x{};
    int count = 0;
};

/// Of a x^2 + b x + c, both by sums that do not cancel.
Roots roots_of(double a, double b, double c) {
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return {};
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    Roots roots;
    for (const double x : {c / q, q / a})
        if (std::isfinite(x)) roots.x.at(static_cast<std::size_t>(roots.count++)) = x;
    return roots;
}

bool is_inside(double x) {
    return x >= -kSlack && x <= 1 + kSlack;
}

/// t and (u, v) of one meeting: P(u, v) = origin + t direction.
struct Meeting3 {
    double t = 0;
    Vec2d uv{0};
};

/// One step of Newton's method in all three unknowns: it takes away what the quadratic rounded.
void refine(const Bilinear& patch, const Vec3d& origin, const Vec3d& direction, Meeting3& m) {
    const Vec3d du = patch.du(m.uv.y);
    const Vec3d dv = patch.dv(m.uv.x);
    const Vec3d area = du.cross(dv);
    const double determinant = area.dot(direction);
    const Vec3d apart = origin + direction * m.t - patch.point(m.uv);
    const Vec2d step(apart.dot(dv.cross(direction)) / determinant,
                     apart.dot(direction.cross(du)) / determinant);
    if (!(std::abs(step.x) < 1e-4 && std::abs(step.y) < 1e-4)) return;  // tangent: leave it
    m.uv += step;
    m.t -= apart.dot(area) / determinant;
}

}  // namespace

/// Rulings of equal u run from A(u) on the side v = 0 along E(u). The line meets one where
/// (A - origin) . (E x direction) = 0, a quadratic equation in u.
Bilinear::Meetings Bilinear::meet(const Vec3d& origin, const Vec3d& direction) const {
    const Vec3d a0 = corner[0] - origin;
    const Vec3d a1 = corner[1] - corner[0];
    const Vec3d e0 = corner[2] - corner[0];
    const Vec3d e1 = corner[3] - corner[1] - e0;
    const Vec3d n0 = e0.cross(direction);
    const Vec3d n1 = e1.cross(direction);
    const Roots roots = roots_of(a1.dot(n1), a0.dot(n1) + a1.dot(n0), a0.dot(n0));
    Meetings result{};
    for (int i = 0; i < roots.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double u = roots.x.at(k);
        if (!(u >= -1e-6 && u <= 1 + 1e-6)) continue;
        const Vec3d n = n0 + n1 * u;
        const Vec3d from = -a0 - a1 * u;  // origin - A
        Meeting3 m{from.cross(e0 + e1 * u).dot(n) / n.dot(n),
                   {u, from.cross(direction).dot(n) / n.dot(n)}};
        refine(*this, origin, direction, m);
        if (!is_inside(m.uv.x) || !is_inside(m.uv.y) || !std::isfinite(m.t)) continue;
        result.line.on.at(k) = true;
        result.line.t.at(k) = m.t;
        result.uv.at(k) = {std::clamp(m.uv.x, 0.0, 1.0), std::clamp(m.uv.y, 0.0, 1.0)};
    }
    if (result.line.on[1] && (!result.line.on[0] || result.line.t[1] < result.line.t[0])) {
        std::swap(result.line.t[0], result.line.t[1]);
        std::swap(result.line.on[0], result.line.on[1]);
        std::swap(result.uv[0], result.uv[1]);
    }
    return result;
}

/// By Gauss-Newton from the best of a grid where the line misses by a rounding
/// error: near the border, or where the patch has no normal.
Vec2d Bilinear::locate(const Vec3d& on, const Vec3d& direction) const {
    const Meetings met = meet(on, direction);
    const bool second =
        met.line.on[1] && (!met.line.on[0] || std::abs(met.line.t[1]) < std::abs(met.line.t[0]));
    if (second) return met.uv[1];
    if (met.line.on[0]) return met.uv[0];
    constexpr int kSide = 4;
    Vec2d best(0.5);
    for (int i = 0; i <= kSide * kSide + 2 * kSide; ++i) {
        const int row = i / (kSide + 1);
        const Vec2d uv(static_cast<double>(i % (kSide + 1)) / kSide,
                       static_cast<double>(row) / kSide);
        if ((point(uv) - on).length2() < (point(best) - on).length2()) best = uv;
    }
    for (int step = 0; step < 8; ++step) {
        const Vec3d x = du(best.y);
        const Vec3d y = dv(best.x);
        const Vec3d apart = on - point(best);
        const double determinant = x.length2() * y.length2() - x.dot(y) * x.dot(y);
        if (!(determinant > 0)) break;
        best.x += (apart.dot(x) * y.length2() - apart.dot(y) * x.dot(y)) / determinant;
        best.y += (apart.dot(y) * x.length2() - apart.dot(x) * x.dot(y)) / determinant;
        best = {std::clamp(best.x, 0.0, 1.0), std::clamp(best.y, 0.0, 1.0)};
    }
    return best;
}

/// The area vector is linear: where the patch is flat, and does not fold, its mean length is that
/// of the middle.
double Bilinear::area() const {
    const Vec3d middle = area_vector({0.5, 0.5});
    bool is_flat = true;
    for (const Vec2d& uv : {Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1), Vec2d(1, 1)}) {
        const Vec3d here = area_vector(uv);
        is_flat = is_flat && here.cross(middle).length() <= 1e-12 * middle.length2() &&
                  here.dot(middle) >= 0;
    }
    if (is_flat) return middle.length();
    return integrate_rectangle(
        [&](double u, double v) {
            return area_vector({u, v}).length();
        },
        {0, 1}, {0, 1}, 1e-8);
}

Bilinear Bilinear::image(const Affine& map) const {
    Bilinear result;
    std::transform(corner.begin(), corner.end(), result.corner.begin(),
                   [&](const Vec3d& p) { return map.point(p); });
    return result;
}

Bounds Bilinear::bounds() const {
    Bounds box;
    for (const Vec3d& p : corner) box.extend(p);
    return box;
}

}  // namespace sunfleck::engine
