// Fog for a whole scene.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine {

struct Fog {
    double mean_free_path =
        1;              // in units of the scene: between two events of scattering or absorption
    double albedo = 1;  // part of them that scatters
    double g = 0;       // mean cosine of the angle by which they bend
};

/// Fills all space that names no medium, but for the inside of solid glass. Where light comes from
/// afar the fog ends at a sphere around the scene.
void fill_with_fog(SceneDescription& scene, const Fog& fog);

}  // namespace sunfleck::engine
