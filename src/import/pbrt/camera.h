// The Camera statement as one of our cameras.
#pragma once

#include "camera/camera.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// The types of Camera, and what each means.
std::span<const WordRow> camera_words();

/// Returns the camera of a Camera statement, for a film of that size.
/// @throws Error  for an unknown type, and for values out of range.
Camera camera_of(const Statement& camera, const Matrix& to_world, const Vec2i& size);

/// Reads the last Camera statement; call it after finish_film(). Without one the camera stands at
/// the origin and looks along +z (pbrt-v4).
/// @throws Error for an unknown type, for "realistic", and for values out of range.
void finish_camera(Reading& reading);

}  // namespace sunfleck::engine
