// Sight: whether anything stands between a visible point and a photon of its disc.
//
// In:  a disc, a photon that it accepts. Out: whether the disc's own point sees it.
#pragma once

#include "geometry/geometry.h"
#include "visible_points/visible_point.h"

namespace sunfleck::engine {

/// Returns whether a disc sees a photon, from a quarter of its radius above both surfaces: what is
/// lower, as a carpet on a floor, hides nothing.
inline bool sees(const Geometry& geometry, const Disc& disc, const Photon& photon) {
    const float height = kDiscFlatness * disc.radius_for(photon.kind);
    const bool is_behind = disc.normal.dot(photon.normal) < 0;
    const Vec3 above = (is_behind ? -photon.normal : photon.normal) * height;
    const Vec3 from = disc.position + disc.normal * height;
    const Vec3 way = photon.position + above - from;
    const float length = way.length();
    return !(length > 0) || !geometry.occluded({from, way / length, length});
}

}  // namespace sunfleck::engine
