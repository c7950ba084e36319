// Choice of an origin near the centre of a scene, relative to which coordinates are small.
//
// Floats resolve about 2^-24 of their value, so objects far from the origin compared with their
// size are resolved badly. Coordinates relative to a point near their centre avoid that.
#pragma once

#include "geometry/bounds.h"

#include <vector>

namespace sunfleck::engine {

/// A centre, and a distance within which objects lie.
struct Middle {
    Vec3d center{0};
    double radius = 0;
};

/// Returns the median position of boxes, and the median distance from it to the far side of a box.
/// A few huge or distant objects (a sky dome, a sun) hardly change it.
/// @param boxes  empty ones do not count. @return zeros if there are none.
Middle middle_of(const std::vector<Bounds>& boxes);

/// Returns the origin for coordinates around a centre: zero if no coordinate of the centre exceeds
/// 32 radii; else the centre, rounded to a grid whose step is the first power of two above the
/// radius. So objects near the origin keep their coordinates, differences to the origin are exact
/// for coordinates of few digits, and objects moved by whole steps get the same coordinates.
Vec3d origin_near(const Middle& middle);

}  // namespace sunfleck::engine
