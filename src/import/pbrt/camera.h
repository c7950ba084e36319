// The Camera statement as a perspective camera.
#pragma once

namespace sunfleck::engine {

struct Reading;

/// Reads the last Camera statement; call it after finish_film(). Without one the camera stands at
/// the origin and looks along +z (pbrt-v4).
/// @throws Error for other cameras than "perspective", and for values out of range.
void finish_camera(Reading& reading);

}  // namespace sunfleck::engine
