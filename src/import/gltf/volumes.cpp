// Attenuation becomes absorption and scattering.
#include "import/gltf/volumes.h"

#include "scene/absorption.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace sunfleck::engine {
namespace {

constexpr const char* kScatter = "KHR_materials_volume_scatter";

/// Divides the attenuation of a volume into absorption and scattering.
void add_scattering(const JsonPlace& scatter, GltfVolume& volume) {
    constexpr double kMostBent = 0.999;
    volume.g = std::clamp(scatter.number("scatterAnisotropy", 0, -1, 1), -kMostBent, kMostBent);
    // Earlier drafts have multiscatterColor.
    const Vec3d many =
        scatter.triple("multiscatterColorFactor", scatter.triple("multiscatterColor", Vec3d(0)));
    for (int c = 0; c < 3; ++c) {
        const double attenuation = volume.absorption[c];
        volume.scattering[c] = attenuation * single_albedo(std::clamp(many[c], 0.0, 1.0), volume.g);
        volume.absorption[c] = attenuation - volume.scattering[c];
    }
}

}  // namespace

double single_albedo(double many, double g) {
    const double s =
        4.09712 + 4.20863 * many - std::sqrt(9.59217 + 41.6808 * many + 17.7126 * many * many);
    return std::clamp((1 - s * s) / (1 - g * s * s), 0.0, 1.0);
}

GltfVolume volume_of(const JsonPlace& material, SceneDescription& scene) {
    constexpr double kMost = std::numeric_limits<double>::infinity();
    GltfVolume volume;
    if (const auto given = material.extension("KHR_materials_volume")) {
        volume.is_given = given->number("thicknessFactor", 0, 0, kMost) > 0;
        const double distance = given->number("attenuationDistance", kMost, 0, kMost);
        const Vec3d colour = given->triple("attenuationColor", Vec3d(1));
        if (volume.is_given && distance > 0) volume.absorption = absorption_over(distance, colour);
    }
    const auto scatter = material.extension(kScatter);
    if (!scatter) return volume;
    if (!volume.is_given)
        scene.warnings.add(material.where(), std::string(kScatter) +
                                                 " is left out without KHR_materials_volume of a "
                                                 "thickness above 0");
    else
        add_scattering(*scatter, volume);
    if (scatter->find("multiscatterColorTexture"))
        scene.warnings.add(scatter->where(),
                           "a texture of a volume's colour is left out: its factor alone counts");
    return volume;
}

void warn_of_scattering_left_out(const JsonPlace& material, SceneDescription& scene) {
    if (material.extension(kScatter))
        scene.warnings.add(material.where(),
                           std::string(kScatter) +
                               " is left out where KHR_materials_transmission lets no light in");
}

MediumNumber add_medium(SceneDescription& scene, const GltfVolume& volume) {
    scene.media.all.push_back({Spectrum::rgb_unbounded(Vec3(volume.absorption)),
                               Spectrum::rgb_unbounded(Vec3(volume.scattering)),
                               static_cast<float>(volume.g)});
    return static_cast<MediumNumber>(scene.media.all.size() - 1);
}

}  // namespace sunfleck::engine
