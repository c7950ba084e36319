// The Camera statement as one of our cameras.
#pragma once

#include "import/pbrt/vocabulary_row.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// The types of Camera, and what each means.
std::span<const WordRow> camera_words();

/// Reads the last Camera statement; call it after finish_film(). Without one the camera stands at
/// the origin and looks along +z (pbrt-v4).
/// @throws Error for an unknown type, for "realistic", and for values out of range.
void finish_camera(Reading& reading);

}  // namespace sunfleck::engine
