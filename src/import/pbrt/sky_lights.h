// Words of our own, which pbrt-v4 refuses: LightSource "sun" and "sky".
#pragma once

#include "import/pbrt/parameters.h"
#include "light/light.h"

#include <vector>

namespace sunfleck::engine {

struct Reading;

/// Converts a LightSource "sun": a "distant" light that is a disc of "float angle" degrees.
Light sun_light(const Statement& statement, Reading& reading);

/// Converts a LightSource "sky": the clear sky of sky/daylight.h with its sun. The current matrix
/// turns east, north and up from x, y and z.
std::vector<Light> sky_lights(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
