// Punctual lights: units, cones, places.
#include "import/gltf/lights.h"

#include "gltf_files.h"
#include "import/gltf/units.h"

namespace sunfleck::engine {
namespace {

using testing_support::square_json;
using testing_support::warns;

class GltfLights : public testing_support::GltfFiles {
protected:
    /// The scene of a light at (1, 2, 3), turned so that its -z looks along -y.
    static std::string scene_of(const std::string& light) {
        return R"("extensions":{"KHR_lights_punctual":{"lights":[{)" + light + R"(}]}},
"scenes":[{"nodes":[0]}],"nodes":[{"translation":[1,2,3],"rotation":[-0.70710678118,0,0,0.70710678118],
"extensions":{"KHR_lights_punctual":{"light":0}}}])";
    }
    Light light_of(const std::string& light) const { return read(scene_of(light)).lights.at(0); }
};

TEST_F(GltfLights, points_have_candela) {
    const auto point =
        std::get<PointLight>(light_of(R"("type":"point","intensity":1366,"color":[1,0.5,0])"));
    EXPECT_EQ(point.position, Vec3d(1, 2, 3));
    EXPECT_LT((point.curve.to_rgb() - Vec3(2, 1, 0)).length(), 1e-3F);
}

TEST_F(GltfLights, suns_have_lux_and_a_direction) {
    const auto sun = std::get<DistantLight>(light_of(R"("type":"directional","intensity":683)"));
    EXPECT_LT((sun.direction - Vec3d(0, -1, 0)).length(), 1e-9);
    EXPECT_NEAR(sun.curve.luminance(), 1, 1e-5);
}

TEST_F(GltfLights, spots_have_cones) {
    const auto spot = std::get<SpotLight>(
        light_of(R"("type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":1})"));
    EXPECT_LT((spot.axis - Vec3d(0, -1, 0)).length(), 1e-9);
    EXPECT_NEAR(spot.cos_start, std::cos(0.5), 1e-12);
    EXPECT_NEAR(spot.cos_total, std::cos(1), 1e-12);
    const auto usual = std::get<SpotLight>(light_of(R"("type":"spot")"));
    EXPECT_NEAR(usual.cos_total, std::cos(kPiDouble / 4), 1e-12);
    EXPECT_NE(fault_of(scene_of(R"("type":"spot","spot":{"innerConeAngle":1})")), "");
}

TEST_F(GltfLights, that_cannot_be_are_refused) {
    EXPECT_EQ(fault_of(scene_of(R"("type":"area")")),
              "scene.gltf: extensions.KHR_lights_punctual.lights[0].type: is no type of light; "
              "write point, spot or directional");
    EXPECT_NE(fault_of(scene_of(R"("type":"point","intensity":-1)")), "");
    EXPECT_NE(fault_of(scene_of(R"("type":"point","intensity":1e40)")), "");
}

}  // namespace
}  // namespace sunfleck::engine
