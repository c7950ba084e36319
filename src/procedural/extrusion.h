// Flat shapes given thickness: boards, walls with openings, hands of a clock, curtains.
#pragma once

#include "procedural/convex.h"

#include <vector>

namespace sunfleck::engine {

/// A closed body over a flat shape, with its normals outwards.
/// @param edge, holes  counter-clockwise from above, at any height, as for fill(); no three corners
///                     in a row on one line.
/// @param low, high    the heights between which the body lies, low < high.
/// @return 4 n + 4 h - 4 triangles for n corners in all and h holes.
Mesh extrude(const Polygon& edge, const std::vector<Polygon>& holes, double low, double high);

/// Counter-clockwise from the corner of least x and y.
Polygon rectangle(double left, double front, double right, double back);

/// `corners` points of an ellipse around the origin, the first at x > 0, y = 0.
Polygon ellipse(double half_x, double half_y, std::size_t corners);

/// An upright opening with a round top: a rectangle under half a circle of its width.
/// @param spring  height where the half circle begins; the top is half a width above.
/// @param steps   edges of the half circle.
Polygon arched(double left, double low, double right, double spring, std::size_t steps);

}  // namespace sunfleck::engine
