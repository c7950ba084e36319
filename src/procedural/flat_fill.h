// Triangles of a flat polygon with holes that use its corners alone, so that surfaces that meet it
// along its edges stay closed.
#pragma once

#include "procedural/convex.h"

#include <vector>

namespace sunfleck::engine {

/// Adds the part of a horizontal polygon that its holes leave, facing up.
/// @param edge   without self-crossing, counter-clockwise from above; all at one height.
/// @param holes  within the edge, apart from it and from each other; counter-clockwise from above.
void fill(Mesh& mesh, const Polygon& edge, const std::vector<Polygon>& holes);

}  // namespace sunfleck::engine
