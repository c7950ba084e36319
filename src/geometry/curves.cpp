// Pieces of curves: evaluation, cutting, boxes.
#include "geometry/curves.h"

#include "geometry/quadrature.h"
#include "geometry/sweep.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

Vec3d unit_or_zero(const Vec3d& v) {
    const double length2 = v.length2();
    return length2 > 0 ? v * (1 / std::sqrt(length2)) : Vec3d(0);
}

/// The blossom of a cubic: symmetric, linear in each parameter, C(u) for three equal ones.
Vec3d blossom(const Bezier& p, double a, double b, double c) {
    const auto mix = [](const Vec3d& x, const Vec3d& y, double w) { return x * (1 - w) + y * w; };
    const Vec3d first = mix(mix(p[0], p[1], a), mix(p[1], p[2], a), b);
    const Vec3d second = mix(mix(p[1], p[2], a), mix(p[2], p[3], a), b);
    return mix(first, second, c);
}

}  // namespace

CurvePoint evaluate(const Bezier& p, double u) {
    const double w = 1 - u;
    const Vec3d d0 = p[1] - p[0];
    const Vec3d d1 = p[2] - p[1];
    const Vec3d d2 = p[3] - p[2];
    return {(p[0] * w + p[1] * (3 * u)) * (w * w) + (p[2] * (3 * w) + p[3] * u) * (u * u),
            (d0 * (w * w) + d1 * (2 * u * w) + d2 * (u * u)) * 3,
            ((d1 - d0) * w + (d2 - d1) * u) * 6};
}

Bezier part_of(const Bezier& curve, double from, double to) {
    return {blossom(curve, from, from, from), blossom(curve, from, from, to),
            blossom(curve, from, to, to), blossom(curve, to, to, to)};
}

CurvePiece Curves::element(std::uint32_t piece) const {
    const CurveSegment& segment = segments[piece / kPieces];
    CurvePiece result;
    result.kind = kind;
    for (std::size_t i = 0; i < 4; ++i) result.curve.at(i) = Vec3d(segment.points.at(i));
    result.width = {segment.width[0], segment.width[1]};
    result.from = double(piece % kPieces) / kPieces;
    result.to = double(piece % kPieces + 1) / kPieces;
    if (kind == CurveKind::ribbon) {
        result.normal = {unit_or_zero(Vec3d(segment.normal[0])),
                         unit_or_zero(Vec3d(segment.normal[1]))};
        const double cosine = result.normal[0].dot(result.normal[1]);
        result.turn = cosine < 1 - 1e-6 ? arc_cosine(cosine) : 0;
    }
    return result;
}

/// Normals are turned evenly from one end to the other, along the great circle (pbrt-v4).
Vec3d CurvePiece::across_ribbon(const CurvePoint& here, double u) const {
    Vec3d n = normal[0] * (1 - u) + normal[1] * u;
    if (turn > 0) n = normal[0] * sin_cos((1 - u) * turn).sin + normal[1] * sin_cos(u * turn).sin;
    return unit_or_zero(n.cross(here.first));
}

Bounds CurvePiece::bounds(const Affine& map) const {
    const double reach = std::max(width_at(from), width_at(to)) / 2;
    Vec3d half;
    for (int i = 0; i < 3; ++i) half[i] = reach * Vec3d(map.x[i], map.y[i], map.z[i]).length();
    Bounds box;
    for (const Vec3d& p : part_of(curve, from, to)) {
        box.extend(map.point(p) - half);
        box.extend(map.point(p) + half);
    }
    return box;
}

CrossingsOf<CurvePiece::kMostCrossings> CurvePiece::crossings(const Vec3d& origin,
                                                              const Vec3d& direction) const {
    std::array<CurveMeeting, kMostCrossings> found;
    const std::size_t count = meet(*this, origin, direction, found);
    CrossingsOf<kMostCrossings> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.t.at(i) = found.at(i).t;
        result.on.at(i) = true;
    }
    return result;
}

}  // namespace sunfleck::engine
