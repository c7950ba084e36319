// A piece of a cubic Bezier curve with a width: a strip or a tube, intersected in double.
//
// flat:      a strip that turns around the curve to face each ray, as pbrt-v4's.
// cylinder:  the tube of circles around the curve, open at its ends.
// ribbon:    the strip whose normal is as near to the given one as the curve lets it be.
// All parameters u are those of the whole Bezier segment, in [0, 1].
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
/// The control points of the part with u in [from, to] (blossoming).
Bezier part_of(const Bezier& curve, double from, double to);

/// Where a line meets a piece.
struct CurveMeeting {
    double t = 0;
    double u = 0;
    double across = 0;  // signed distance from the curve, along +v; of a tube as the line sees it
};

struct CurvePiece {
    static constexpr std::size_t kMostCrossings = 8;

    CurveKind kind = CurveKind::flat;
    Bezier curve;
    std::array<double, 2> width{};                    // at u = 0 and u = 1, linear between them
    std::array<Vec3d, 2> normal{Vec3d(0), Vec3d(0)};  // of ribbons at both ends, unit
    double turn = 0;                                  // the angle between them, radians
    double from = 0;                                  // this piece: u in [from, to]
    double to = 1;

    CrossingsOf<kMostCrossings> crossings(const Vec3d& origin, const Vec3d& direction) const;
    LocalSurface at(const Vec3d& near, const Vec3d& direction) const;
    /// Around the control points: not tight.
    Bounds bounds(const Affine& map) const;

    double width_at(double u) const { return width[0] * (1 - u) + width[1] * u; }
    /// The direction across a ribbon, unit, towards greater v. @param here  of `curve` at u.
    Vec3d across_ribbon(const CurvePoint& here, double u) const;
};

static_assert(ExactShape<CurvePiece>);

/// All meetings of a line with a piece from the line's start on, and some before it, in any order.
/// @return how many.
std::size_t meet(const CurvePiece& piece, const Vec3d& origin, const Vec3d& direction,
                 std::array<CurveMeeting, CurvePiece::kMostCrossings>& found);

}  // namespace sunfleck::engine
