// Environments as pictures of equal areas, as pbrt-v4's infinite lights have them.
#pragma once

#include "light/image_infinite_light.h"
#include "light/portal_light.h"
#include "light/sun_light.h"

#include <memory>
#include <optional>

namespace sunfleck::engine {

/// Returns the picture of a light with RGB, as it is where it has equal areas; else resampled: each
/// texel is the mean of its part of the sky, and the whole has the light that the given one has.
std::shared_ptr<const Image> equal_area_image(const ImageInfiniteLight& light);

/// Returns what is seen through a portal, as a picture of the portal's frame (z out); behind it,
/// where nobody looks, is its mirror image, so that texels at the horizon are whole.
std::shared_ptr<const Image> portal_view(const PortalLight& light);

/// A sun as a picture around +z: it holds the radiance over `peak`.
struct SunImage {
    std::shared_ptr<const Image> image;
    float peak = 1;  // radiance over the curve
    Affine to_world;
};

/// Returns nothing for a sun that is too small for a picture of moderate size.
std::optional<SunImage> sun_image(const SunLight& light);

}  // namespace sunfleck::engine
