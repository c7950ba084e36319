// What solid glass of glTF is filled with: a medium that absorbs light and scatters it.
//
// Source: KHR_materials_volume; the drafts of KHR_materials_volume_scatter and of its successor
// KHR_materials_scatter.
#pragma once

#include "import/gltf/json_place.h"
#include "math/vector.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// A medium per metre, in linear sRGB.
struct GltfVolume {
    bool is_given = false;  // by KHR_materials_volume with a thickness
    Vec3d absorption{0};
    Vec3d scattering{0};
    double g = 0;  // mean cosine of the angle by which light is bent
};

/// Returns the share of light that one event leaves, of the share that a deep medium throws back
/// after many events (Kulla and Conty 2017).
/// @param many  in [0, 1]. @param g  in (-1, 1).
double single_albedo(double many, double g);

/// Returns the volume of a material that transmits, and warns of what is left out.
GltfVolume volume_of(const JsonPlace& material, SceneDescription& scene);

/// Warns of a volume that scatters where light does not get into it.
void warn_of_scattering_left_out(const JsonPlace& material, SceneDescription& scene);

/// Adds the medium. @return its number.
MediumNumber add_medium(SceneDescription& scene, const GltfVolume& volume);

}  // namespace sunfleck::engine
