// Where things stand: a place near their middle from which their coordinates are small numbers.
//
// Floats resolve some 2^-24 of their size: what stands far from the origin, compared with its own
// size, is resolved badly. Numbers relative to a place near its middle resolve it as well as if it
// stood at the origin.
#pragma once

#include "geometry/bounds.h"

#include <vector>

namespace sunfleck::engine {

/// A point and a distance within which things stand.
struct Middle {
    Vec3d center{0};
    double radius = 0;
};

/// The median place of boxes, and the median distance from it to the far side of a box. A few huge
/// or distant things (a sky dome, a sun) among many others do not change it much.
/// @param boxes  those that are empty do not count. @return all zero if there are none.
Middle middle_of(const std::vector<Bounds>& boxes);

/// The origin to which coordinates around a middle should be relative: zero, if no coordinate of
/// its centre exceeds 32 radii; else the centre, rounded to a grid whose step is the first power of
/// two above the radius. So things near the origin stay where they are, differences to the origin
/// are exact wherever the coordinates have few digits, and the same things moved by whole steps get
/// the same coordinates.
Vec3d origin_near(const Middle& middle);

}  // namespace sunfleck::engine
