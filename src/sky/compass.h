// Compass: where up, north and east are in the world of a scene.
#pragma once

#include "geometry/affine.h"
#include "scene/import_settings.h"

namespace sunfleck::engine {

/// Returns x as east, y as north, z as up. Where y is up, north is -z, into the usual picture.
/// @param north  degrees from there to the scene's north, clockwise as seen from above.
inline Affine compass(UpAxis up, double north) {
    const SinCos turn = sin_cos_2pi(north / 360);
    Affine axes;
    const Vec3d ahead = up == UpAxis::z ? Vec3d(0, 1, 0) : Vec3d(0, 0, -1);
    const Vec3d right(1, 0, 0);
    axes.x = right * turn.cos - ahead * turn.sin;
    axes.y = right * turn.sin + ahead * turn.cos;
    axes.z = up == UpAxis::z ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0);
    return axes;
}

}  // namespace sunfleck::engine
