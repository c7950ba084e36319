// The sun as a light: a disc of 0.51 degrees, darker towards its limb.
#pragma once

#include "light/sun_light.h"
#include "sky/sky_model.h"

namespace sunfleck::engine {

/// Returns the irradiance that the whole disc brings to a plane that faces it, per nanometre.
/// @param elevation  of the disc's middle, in radians; all of it counts as being there.
SkyCurve sun_irradiance(const SkyModel& model, double elevation);

/// Returns the disc. Its darkening is the same at all wavelengths: that of its luminance.
/// @param direction  unit, in which its light travels.
SunLight sun_disc(const SkyModel& model, double elevation, const Vec3d& direction);

}  // namespace sunfleck::engine
