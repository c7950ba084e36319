// Conversion of the Camera statement to a camera.
#pragma once

namespace sunfleck::engine {

struct Reading;

/// Converts the last Camera statement; finish_film() comes first. Without a statement the camera is
/// at the origin and looks along +z (pbrt-v4).
/// @throws Error  for cameras that are not simulated, and for values out of range.
void finish_camera(Reading& reading);

}  // namespace sunfleck::engine
