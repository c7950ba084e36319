// The medium around a point, by the surfaces on one way from there, whatever they are made of.
#pragma once

#include "scene/media.h"
#include "scene/surfaces.h"

namespace sunfleck::engine {

/// Returns the medium that the next surface names which separates media.
/// @param last  the medium behind all surfaces, where there is none.
MediumNumber medium_around(const Surfaces& surfaces, const Vec3& point, MediumNumber last);

/// Returns the medium behind all surfaces. @param medium  at the point.
MediumNumber medium_behind_all(const Surfaces& surfaces, const Vec3& point, MediumNumber medium);

}  // namespace sunfleck::engine
