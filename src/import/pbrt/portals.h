// Infinite lights that come through a rectangle.
#pragma once

#include "import/pbrt/parameters.h"
#include "light/light.h"

namespace sunfleck::engine {

struct Reading;

/// Of a LightSource "infinite" with "point3 portal": four corners in the world, whatever the
/// present matrix; the sky lies where (p3 - p0) x (p1 - p0) points (pbrt-v4).
/// @throws Error for corners that are those of no rectangle.
Light portal_light(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
