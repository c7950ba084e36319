// The value of --sun: angles, or a moment and a place.
#pragma once

#include "sky/solar_position.h"

#include <string>

namespace sunfleck::engine {

/// Reads "AZIMUTH,ELEVATION" in degrees, or "DATE,TIME,LATITUDE,LONGITUDE", such as
/// "2026-06-21,15:30+02:00,48.2,16.4".
/// @throws Error  that names the flag, for a text that is neither, and for a sun that is below the
/// horizon.
SunPosition read_sun(const std::string& text, const std::string& flag);

}  // namespace sunfleck::engine
