// Extrusion of flat shapes: boards, walls with openings, clock hands, curtains.
#pragma once

#include "procedural/convex.h"

#include <vector>

namespace sunfleck::engine {

/// Returns a closed body over a flat shape, with normals outwards.
/// @param edge, holes  counter-clockwise from above, at any height, as for fill(); no three
/// consecutive corners on a line.
/// @param low, high    heights of bottom and top, low < high.
/// @return 4 n + 4 h - 4 triangles for n corners in all and h holes.
Mesh extrude(const Polygon& edge, const std::vector<Polygon>& holes, double low, double high);

/// Returns corners counter-clockwise from the one with least x and y.
Polygon rectangle(double left, double front, double right, double back);

/// Returns `corners` points of an ellipse around the origin, the first at x > 0, y = 0.
Polygon ellipse(double half_x, double half_y, std::size_t corners);

/// Returns an upright opening with a round top: a rectangle under a half circle.
/// @param spring  height of the start of the half circle; the top is half a width above.
/// @param steps   edges of the half circle.
Polygon arched(double left, double low, double right, double spring, std::size_t steps);

}  // namespace sunfleck::engine
