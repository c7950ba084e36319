// Shape "curve" as a chain of cubic Bezier segments.
#pragma once

#include "import/pbrt/local_points.h"
#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

struct Reading;

/// Bases "bezier" and "bspline" of degrees 2 and 3 (pbrt-v4). @throws Error for control points and
/// normals that make no whole segments, and for widths that are negative.
LocalShape curve(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
