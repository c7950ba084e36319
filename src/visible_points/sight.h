// Sight: whether anything stands between a visible point and a photon of its disc.
//
// In:  a disc, a place that it accepts. Out: whether the disc's own point sees it.
#pragma once

#include "geometry/geometry.h"
#include "visible_points/visible_point.h"

namespace sunfleck::engine {

/// Returns whether a disc sees a place on a surface, from a quarter of its radius above both: what
/// is lower, as a carpet on a floor, hides nothing.
/// @param normal  of the surface there, on the disc's side. @param radius  of the disc.
inline bool sees(const Geometry& geometry, const Disc& disc, const Vec3& place, const Vec3& normal,
                 float radius) {
    const float height = kDiscFlatness * radius;
    const Vec3 from = disc.position + disc.normal * height;
    const Vec3 way = place + normal * height - from;
    const float length = way.length();
    return !(length > 0) || !geometry.occluded({from, way / length, length});
}

}  // namespace sunfleck::engine
