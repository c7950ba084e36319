// An environment picture as a light of a scene.
#pragma once

#include "geometry/affine.h"
#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

struct EnvironmentPicture {
    std::string file;  // square (octahedral, of equal areas) or twice as wide as high
    double scale = 1;  // radiance of a texel of one
};

/// Reads the picture and adds it to the scene's lights.
/// @param axes  x east, y north, z up in the world (sky/compass.h). A picture of latitude and
///        longitude has east in its middle and north to the left of it.
/// @throws Error  for a file that cannot be read, or has another shape.
void add_environment(SceneDescription& scene, const EnvironmentPicture& picture,
                     const Affine& axes);

}  // namespace sunfleck::engine
