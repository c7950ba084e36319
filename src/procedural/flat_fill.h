// Triangulation of flat polygons with holes by their corners alone, so that surfaces adjacent along
// the edges stay closed.
#pragma once

#include "procedural/convex.h"

#include <vector>

namespace sunfleck::engine {

/// Adds a horizontal polygon without its holes, facing up.
/// @param edge   without self-intersection, counter-clockwise from above; all at one height.
/// @param holes  within the edge, disjoint from it and from each other; counter-clockwise from
/// above.
void fill(Mesh& mesh, const Polygon& edge, const std::vector<Polygon>& holes);

}  // namespace sunfleck::engine
