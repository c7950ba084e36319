// Infinite lights with a portal.
#pragma once

#include "import/pbrt/parameters.h"
#include "light/light.h"

namespace sunfleck::engine {

struct Reading;

/// Converts a LightSource "infinite" with "point3 portal": four corners in the world, whatever the
/// current matrix; the environment is on the side of (p3 - p0) x (p1 - p0) (pbrt-v4).
/// @throws Error  if the corners do not form a rectangle.
Light portal_light(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
