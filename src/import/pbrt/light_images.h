// Images of lights, and the rotation of the lights.
#pragma once

#include "geometry/affine.h"
#include "import/pbrt/parameters.h"
#include "light/direction_map.h"
#include "light/light_image.h"

#include <memory>

namespace sunfleck::engine {

struct Reading;

/// Returns the image "filename" of a light. @throws Error  for texels that are not finite.
Image light_image(const Statement& statement, Reading& reading);

/// An image of all directions.
struct EnvironmentImage {
    Image image;
    DirectionMap map;
};

/// Returns the environment "filename" of a light. A map of latitude and longitude is told in a
/// warning, for pbrt-v4 does not read it.
/// @throws Error  also for an image that is neither square nor twice as wide as high.
EnvironmentImage environment_image(const Statement& statement, Reading& reading);

/// Returns an image of all directions with one channel: the mean of each texel's colours.
std::shared_ptr<const LightImage> intensity_image(const Statement& statement, Reading& reading);

/// Returns the current matrix as a rotation, perhaps with a reflection. If the matrix scales or
/// shears, the nearest one by orthonormalisation in the order x, y, z, with a warning.
Affine turn_of(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
