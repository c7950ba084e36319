// The end of a reading: fills in what had to wait until all statements are known.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine {

struct Reading;

/// Takes the finished scene out of a reading.
/// @throws Error  for names that nothing was made by and statements that cannot be used, and one
/// for all missing files.
SceneDescription finish_scene(Reading& reading);

}  // namespace sunfleck::engine
