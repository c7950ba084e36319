// Sight: whether anything stands between a visible point and a photon that it accepts.
//
// In:  a disc or a cylinder, a photon. Out: whether the disc's own point or the cylinder's axis
// sees it.
#pragma once

#include "geometry/geometry.h"
#include "visible_points/visible_point.h"

namespace sunfleck::engine {

/// Returns whether the axis of a cylinder sees a photon, straight across. Borders of media hide
/// what is behind them, too.
inline bool axis_sees(const Geometry& geometry, const Disc& cylinder, const Vec3& photon) {
    const Vec3 from =
        cylinder.position + cylinder.normal * cylinder.normal.dot(photon - cylinder.position);
    const Vec3 way = photon - from;
    const float length = way.length();
    return !(length > 0) || !geometry.occluded({from, way / length, length});
}

/// Returns whether a disc sees a photon, from a quarter of its radius above both surfaces: what is
/// lower, as a carpet on a floor, hides nothing.
inline bool disc_sees(const Geometry& geometry, const Disc& disc, const Photon& photon) {
    const float height = kDiscFlatness * disc.radius_for(photon.kind);
    const bool is_behind = disc.normal.dot(photon.normal) < 0;
    const Vec3 above = (is_behind ? -photon.normal : photon.normal) * height;
    const Vec3 from = disc.position + disc.normal * height;
    const Vec3 way = photon.position + above - from;
    const float length = way.length();
    return !(length > 0) || !geometry.occluded({from, way / length, length});
}

/// Returns whether a kernel sees a photon that it accepts.
inline bool sees(const Geometry& geometry, const Disc& disc, const Photon& photon) {
    return photon.in_medium ? axis_sees(geometry, disc, photon.position)
                            : disc_sees(geometry, disc, photon);
}

}  // namespace sunfleck::engine
