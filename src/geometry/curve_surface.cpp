// Normals, tangents and coordinates on curves.
#include "geometry/curve_piece.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

Vec3d unit_or(const Vec3d& v, const Vec3d& otherwise) {
    const double length2 = v.length2();
    return length2 > 0 && std::isfinite(length2) ? v * (1 / std::sqrt(length2)) : otherwise;
}

/// The meeting that was found before, or, where rounding lost it, the nearest point of the curve.
CurveMeeting nearest_meeting(const CurvePiece& piece, const Vec3d& near, const Vec3d& direction) {
    std::array<CurveMeeting, CurvePiece::kMostCrossings> found;
    const std::size_t count = meet(piece, near, direction, found);
    const auto nearer = [](const CurveMeeting& a, const CurveMeeting& b) {
        return std::abs(a.t) < std::abs(b.t);
    };
    if (count > 0) return *std::min_element(found.begin(), found.begin() + count, nearer);
    constexpr int kSteps = 64;
    CurveMeeting best;
    double least = 1e300;
    for (int i = 0; i <= kSteps; ++i) {
        const double u = piece.from + (piece.to - piece.from) * i / kSteps;
        const double distance2 = (evaluate(piece.curve, u).position - near).length2();
        if (!(distance2 < least)) continue;
        least = distance2;
        best.u = u;
    }
    return best;
}

/// Faces where the line comes from.
void flat_strip(const CurvePiece& piece, const CurvePoint& c, double u, const Vec3d& direction,
                LocalSurface& surface) {
    const Vec3d across = unit_or(direction.cross(c.first), Vec3d(0));
    surface.normal = unit_or(across.cross(c.first), -unit_or(direction, {0, 0, 1}));
    surface.tangent = c.first;
    surface.clearance = piece.width_at(u);
}

/// The gradient of |p - C| - radius, where C is the point of the curve nearest to p.
void tube(const CurvePiece& piece, const CurvePoint& c, double u, LocalSurface& surface) {
    const double radius = piece.width_at(u) / 2;
    const double slope = (piece.width[1] - piece.width[0]) / 2;
    const Vec3d apart = surface.position - c.position;
    const double stretch = 1 - apart.dot(c.second) / c.first.length2();
    const Vec3d gradient = apart - c.first * (radius * slope / (c.first.length2() * stretch));
    surface.normal = unit_or(gradient, unit_or(apart, {0, 0, 1}));
    surface.tangent = c.first * stretch + unit_or(apart, Vec3d(0)) * slope;
}

/// dP/du along lines of equal v, with the change of the direction across by differences.
void ribbon(const CurvePiece& piece, const CurvePoint& c, const CurveMeeting& met,
            LocalSurface& surface) {
    constexpr double kStep = 1e-5;
    const auto across_at = [&](double u) {
        return piece.across_ribbon(evaluate(piece.curve, u), u);
    };
    const Vec3d across = across_at(met.u);
    const Vec3d change = (across_at(met.u + kStep) - across_at(met.u - kStep)) / (2 * kStep);
    const double width = piece.width_at(met.u);
    const double widening = width > 0 ? (piece.width[1] - piece.width[0]) / width : 0;
    surface.tangent = c.first + (change + across * widening) * met.across;
    surface.normal = unit_or(surface.tangent.cross(across), {0, 0, 1});
}

}  // namespace

LocalSurface CurvePiece::at(const Vec3d& near, const Vec3d& direction) const {
    const CurveMeeting met = nearest_meeting(*this, near, direction);
    const CurvePoint c = evaluate(curve, met.u);
    const double v = 0.5 + met.across / width_at(met.u);
    LocalSurface surface;
    surface.position = near + direction * met.t;
    surface.uv = {static_cast<float>(met.u),
                  static_cast<float>(std::isfinite(v) ? std::clamp(v, 0.0, 1.0) : 0.5)};
    if (kind == CurveKind::flat) flat_strip(*this, c, met.u, direction, surface);
    if (kind == CurveKind::cylinder) tube(*this, c, met.u, surface);
    if (kind == CurveKind::ribbon) ribbon(*this, c, met, surface);
    if (!(surface.tangent.length2() > 0))
        surface.tangent =
            surface.normal.cross(Vec3d(surface.normal.y, surface.normal.z, -surface.normal.x));
    return surface;
}

}  // namespace sunfleck::engine
