// Conversion of the Camera statement to a camera.
#pragma once

#include "camera/camera.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// Returns the types of Camera, and what each means.
std::span<const WordRow> camera_words();

/// Returns the camera of a Camera statement, for a film of that size.
/// @throws Error  for an unknown type, and for values out of range.
Camera camera_of(const Statement& camera, const Matrix& to_world, const Vec2i& size);

/// Converts the last Camera statement; finish_film() comes first. Without a statement the camera is
/// at the origin and looks along +z (pbrt-v4).
/// @throws Error  for cameras that are not simulated, and for values out of range.
void finish_camera(Reading& reading);

}  // namespace sunfleck::engine
