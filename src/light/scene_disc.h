// Scene disc: the origins of all light of one direction that can reach the scene.
//
// It is perpendicular to the direction, with the radius of the scene sphere, one radius before its
// centre.
#pragma once

#include "light/model.h"
#include "math/warp.h"

namespace sunfleck::engine {

/// Returns the area in m^2.
inline double scene_disc_area(const SceneSphere& sphere) {
    return kPiDouble * sphere.radius * sphere.radius;
}

/// Samples the disc uniformly by the concentric map; continuous in the direction except at -z.
/// @param direction  unit; in which the light travels.
/// @param u  in (0,1)^2.
inline Vec3d scene_disc_point(const SceneSphere& sphere, const Vec3d& direction, const Vec2d& u) {
    const Vec2d disc = concentric_disc(u);
    const Vec3d local(disc.x, disc.y, -1);
    return sphere.center + rotate_z_to(direction, local) * sphere.radius;
}

/// Inverts scene_disc_point() for any point on the line along the direction; the result is outside
/// the unit square for lines that miss the disc.
inline Vec2d scene_disc_square(const SceneSphere& sphere, const Vec3d& direction,
                               const Vec3d& point) {
    const Vec3d local = rotate_to_z(direction, (point - sphere.center) / sphere.radius);
    return disc_to_square({local.x, local.y});
}

}  // namespace sunfleck::engine
