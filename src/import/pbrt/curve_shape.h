// Conversion of Shape "curve" to a chain of cubic Bezier segments.
#pragma once

#include "import/pbrt/local_points.h"
#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

struct Reading;

/// Converts bases "bezier" and "bspline" of degrees 2 and 3 (pbrt-v4).
/// @throws Error  for numbers of control points or normals that do not fit, and for negative
/// widths.
LocalShape curve(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
