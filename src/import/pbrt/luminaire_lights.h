// A word of our own within pbrt's: a goniometric light of an IES file.
#pragma once

#include "import/pbrt/parameters.h"
#include "light/light.h"

namespace sunfleck::engine {

struct Reading;

/// Returns whether "filename" ends in .ies.
bool names_luminaire(const Statement& statement);

/// Converts a LightSource "goniometric" with such a file: its candela times "I", times "scale". The
/// nadir is -y of the current matrix, horizontal angles go from x over z, as in pbrt-v4's pictures.
Light luminaire_light(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
