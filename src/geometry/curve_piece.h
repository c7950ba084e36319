// CurvePiece: part of a cubic Bezier curve with a width, intersected in double as strip or tube.
//
// flat:      a strip that faces each ray, as in pbrt-v4.
// cylinder:  a tube around the curve, open at its ends.
// ribbon:    a strip whose normal is as close to the given one as the curve allows.
// Parameters u refer to the whole Bezier segment, in [0, 1].
#pragma once

#include "geometry/local_surface.h"

namespace sunfleck::engine {

enum class CurveKind { flat, cylinder, ribbon };

/// Position and derivatives of a curve.
struct CurvePoint {
    Vec3d position;
    Vec3d first;   // dC/du
    Vec3d second;  // d2C/du2
};

/// The four control points of a cubic Bezier curve.
using Bezier = std::array<Vec3d, 4>;

CurvePoint evaluate(const Bezier& p, double u);
/// Returns the control points of the part with u in [from, to] (blossoming).
Bezier subcurve(const Bezier& curve, double from, double to);

/// An intersection of a line with a piece.
struct CurveHit {
    double t = 0;
    double u = 0;
    double across = 0;  // signed distance from the curve along +v; of a tube, seen along the line
};

struct CurvePiece {
    static constexpr std::size_t kMostCrossings = 8;

    CurveKind kind = CurveKind::flat;
    Bezier curve;
    std::array<double, 2> width{};                    // at u = 0 and u = 1, linear in between
    std::array<Vec3d, 2> normal{Vec3d(0), Vec3d(0)};  // unit normals of a ribbon at both ends
    double normal_angle = 0;                          // angle between the normals, radians
    double from = 0;                                  // this piece has u in [from, to]
    double to = 1;

    CrossingsOf<kMostCrossings> crossings(const Vec3d& origin, const Vec3d& direction) const;
    LocalSurface at(const Vec3d& near, const Vec3d& direction) const;
    /// Returns bounds of the control points; not tight.
    Bounds bounds(const Affine& map) const;

    double width_at(double u) const { return width[0] * (1 - u) + width[1] * u; }
    /// Returns the unit direction across a ribbon, towards greater v. @param here  point of `curve`
    /// at u.
    Vec3d across_ribbon(const CurvePoint& here, double u) const;
};

static_assert(ExactShape<CurvePiece>);

/// Finds all intersections of a line with a piece from the line's start on, and some before it, in
/// any order.
/// @return their count.
std::size_t intersect(const CurvePiece& piece, const Vec3d& origin, const Vec3d& direction,
                      std::array<CurveHit, CurvePiece::kMostCrossings>& found);

}  // namespace sunfleck::engine
