// Curves: chains of cubic Bezier segments with a width (hair, grass, wires).
#pragma once

#include "geometry/curve_piece.h"

#include <vector>

namespace sunfleck::engine {

struct CurveSegment {
    std::array<Vec3, 4> points;                    // control points
    std::array<float, 2> width;                    // at both ends
    std::array<Vec3, 2> normal{Vec3(0), Vec3(0)};  // of ribbons, at both ends
};

struct Curves {
    /// What one segment is cut into, so that boxes around the pieces are small.
    static constexpr std::uint32_t kPieces = 4;

    CurveKind kind = CurveKind::flat;
    std::vector<CurveSegment> segments;

    std::uint32_t count() const { return kPieces * static_cast<std::uint32_t>(segments.size()); }
    CurvePiece element(std::uint32_t piece) const;
};

static_assert(ExactShapes<Curves>);

}  // namespace sunfleck::engine
