// The disc from which light of one direction meets the whole scene.
//
// Perpendicular to the direction, as wide as the scene's sphere, one radius before its centre.
#pragma once

#include "light/model.h"
#include "math/warp.h"

namespace sunfleck::engine {

/// In m^2.
inline double scene_disc_area(const SceneSphere& sphere) {
    return kPiDouble * sphere.radius * sphere.radius;
}

/// Uniform on the disc. @param direction  unit; the way that the light travels.
/// @param u  in (0,1)^2; concentric map. Continuous in the direction but at -z.
inline Vec3d scene_disc_point(const SceneSphere& sphere, const Vec3d& direction, const Vec2d& u) {
    const Vec2d disc = concentric_disc(u);
    const Vec3d local(disc.x, disc.y, -1);
    return sphere.center + rotate_z_to(direction, local) * sphere.radius;
}

/// The inverse of scene_disc_point(), for any point of the line along the direction; out of the
/// unit square's bounds for lines that miss the disc.
inline Vec2d scene_disc_square(const SceneSphere& sphere, const Vec3d& direction,
                               const Vec3d& point) {
    const Vec3d local = rotate_to_z(direction, (point - sphere.center) / sphere.radius);
    return disc_to_square({local.x, local.y});
}

}  // namespace sunfleck::engine
