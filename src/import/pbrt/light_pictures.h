// Pictures that lights name, and how they are turned.
#pragma once

#include "geometry/affine.h"
#include "import/pbrt/parameters.h"
#include "light/light_picture.h"

#include <memory>

namespace sunfleck::engine {

struct Reading;

/// The "filename" of a light. @throws Error for texels that are not finite.
Image light_image(const Statement& statement, Reading& reading);

/// The same where it stands for all directions. @throws Error also if it is no square.
Image directions_image(const Statement& statement, Reading& reading);
std::shared_ptr<const LightPicture> directions_picture(const Statement& statement,
                                                       Reading& reading);

/// Likewise, of one channel: the mean of the colours of a texel.
std::shared_ptr<const LightPicture> intensity_picture(const Statement& statement, Reading& reading);

/// The present matrix as a rotation, with a reflection if it mirrors. Where it stretches or shears,
/// the nearest in the order x, y, z of axes, and a warning.
Affine turn_of(const Statement& statement, Reading& reading);

}  // namespace sunfleck::engine
