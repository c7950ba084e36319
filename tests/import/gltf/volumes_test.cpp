// Media that fill solid glass: how attenuation is divided.
#include "import/gltf/volumes.h"

#include "gltf_files.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

using testing_support::warns;

/// Van de Hulst's fit (1980) of what a half-space full of a medium throws back of diffuse light.
/// @param one  share that one event leaves.
double thrown_back(double one, double g) {
    const double s = std::sqrt((1 - one) / (1 - g * one));
    return (1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s);
}

class GltfVolumes : public testing_support::GltfFiles {
protected:
    /// A material with extensions beside transmission.
    GltfVolume volume(const std::string& extensions) {
        scene_ = {};
        const nlohmann::json json = nlohmann::json::parse(R"({"extensions":{)" + extensions + "}}");
        return volume_of(JsonPlace(json, "scene.gltf", "materials[0]"), scene_);
    }
    SceneDescription scene_;
};

TEST_F(GltfVolumes, the_colour_is_what_a_deep_medium_throws_back) {
    for (const double g : {-0.5, 0.0, 0.3, 0.9})
        for (const double many : {0.01, 0.1, 0.3, 0.5, 0.8, 0.95}) {
            const double one = single_albedo(many, g);
            EXPECT_NEAR(thrown_back(one, g), many, 2e-3) << many << " g " << g;
        }
    EXPECT_NEAR(single_albedo(0, 0.3), 0, 1e-4);
    EXPECT_NEAR(single_albedo(1, 0.3), 1, 1e-6);
}

/// An albedo of 0.5 by van de Hulst's quadratic equation: s = 0.29712, so 0.91172 of one event.
TEST_F(GltfVolumes, attenuation_is_absorption_and_scattering) {
    for (const char* name : {"multiscatterColor", "multiscatterColorFactor"}) {
        const GltfVolume found = volume(
            R"("KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,
"attenuationColor":[1,0.25,0.5]},"KHR_materials_volume_scatter":{")" +
            std::string(name) + R"(":[0.7,0.5,0]})");
        const double green = std::log(4) / 2;
        EXPECT_EQ(found.scattering.x, 0);
        EXPECT_NEAR(found.scattering.y, 0.91172 * green, 1e-4);
        EXPECT_NEAR(found.absorption.y, (1 - 0.91172) * green, 1e-4);
        EXPECT_NEAR(found.scattering.z, 0, 1e-4);
        EXPECT_NEAR(found.absorption.z, std::log(2) / 2, 1e-4);
        EXPECT_EQ(scene_.warnings.entries().size(), 0U);
    }
}

TEST_F(GltfVolumes, without_a_thickness_there_is_none) {
    const GltfVolume found = volume(
        R"("KHR_materials_volume":{"attenuationDistance":2,"attenuationColor":[1,0.25,0.5]},
"KHR_materials_volume_scatter":{"multiscatterColor":[1,1,1],"multiscatterColorTexture":{}})");
    EXPECT_EQ(found.scattering, Vec3d(0));
    EXPECT_TRUE(warns(scene_, "materials[0]: warning: KHR_materials_volume_scatter is left out"));
    EXPECT_TRUE(warns(scene_, "a texture of a volume's colour is left out"));
}

}  // namespace
}  // namespace sunfleck::engine
