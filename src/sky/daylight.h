// Daylight: a clear sky and its sun as lights of a scene.
//
// In:  the sun's place, turbidity and the ground's albedo; the axes of the world.
// Out: the sky as an environment map, with the sunlit ground below the horizon, and the sun as a
//      disc of 0.51 degrees. 683 times the luminance of a radiance is in cd/m^2.
#pragma once

#include "geometry/affine.h"
#include "scene/description.h"
#include "sky/solar_position.h"

namespace sunfleck::engine {

struct Daylight {
    SunPosition sun{.azimuth = 225, .elevation = 40};  // elevation 0 to 90
    double turbidity = 3;                              // 1 to 10
    double ground_albedo = 0.3;                        // 0 to 1
};

/// Returns the direction to the sun: x east, y north, z up.
Vec3d direction_to(const SunPosition& sun);

struct DaylightLights {
    ImageInfiniteLight sky;
    SunLight sun;
};

/// Returns the lights. The sky has its mean spectrum exactly, and in each direction the colour of
/// its own.
/// @param axes  x east, y north, z up in the world (sky/compass.h).
DaylightLights lights_of(const Daylight& daylight, const Affine& axes);

/// Adds the lights to a scene.
/// @param where  their statement's place.
void add_daylight(SceneDescription& scene, const Daylight& daylight, const Affine& axes,
                  const SourceLocation& where);

}  // namespace sunfleck::engine
