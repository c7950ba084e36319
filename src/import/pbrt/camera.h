// The Camera statement as a perspective camera.
#pragma once

#include "camera/camera.h"
#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

struct Reading;

/// Returns the camera of a Camera statement, for a film of that size.
/// @throws Error  for an unknown type, and for values out of range.
Camera camera_of(const Statement& camera, const Matrix& to_world, const Vec2i& size);

/// Reads the last Camera statement; call it after finish_film(). Without one the camera stands at
/// the origin and looks along +z (pbrt-v4).
/// @throws Error for other cameras than "perspective", and for values out of range.
void finish_camera(Reading& reading);

}  // namespace sunfleck::engine
