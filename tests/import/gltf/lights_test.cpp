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
}

TEST_F(GltfLights, that_cannot_be_are_refused) {
    EXPECT_EQ(fault_of(scene_of(R"("type":"area")")),
              "scene.gltf: extensions.KHR_lights_punctual.lights[0].type: is no type of light; "
              "write point, spot or directional");
    EXPECT_NE(fault_of(scene_of(R"("type":"point","intensity":-1)")), "");
    EXPECT_NE(fault_of(scene_of(R"("type":"point","intensity":1e40)")), "");
}

/// The formula that the extension recommends: the square of what is linear in the cosine.
TEST_F(GltfLights, edges_of_spots_are_those_that_the_extension_recommends) {
    const auto spot = std::get<SpotLight>(
        light_of(R"("type":"spot","spot":{"innerConeAngle":0.3,"outerConeAngle":0.7})"));
    const double scale = 1 / (std::cos(0.3) - std::cos(0.7));
    for (const double angle : {0.1, 0.35, 0.5, 0.65, 0.75}) {
        const double root = std::clamp((std::cos(angle) - std::cos(0.7)) * scale, 0.0, 1.0);
        EXPECT_NEAR(spot.falloff(std::cos(angle)), root * root, 1e-12) << angle;
    }
}

/// Half a turn, as single precision has it, is a little more than half a turn.
TEST_F(GltfLights, spots_may_be_half_spheres_and_have_hard_edges) {
    const auto half = std::get<SpotLight>(
        light_of(R"("type":"spot","spot":{"outerConeAngle":1.5707963705062866})"));
    EXPECT_NEAR(half.cos_total, 0, 1e-7);
    const SceneDescription hard =
        read(scene_of(R"("type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":0.5})"));
    EXPECT_NEAR(std::get<SpotLight>(hard.lights.at(0)).cos_total, std::cos(0.5), 1e-12);
    EXPECT_EQ(std::get<SpotLight>(hard.lights[0]).falloff(std::cos(0.499)), 1);
    EXPECT_EQ(std::get<SpotLight>(hard.lights[0]).falloff(std::cos(0.501)), 0);
    const SceneDescription wide =
        read(scene_of(R"("type":"spot","spot":{"innerConeAngle":0.6,"outerConeAngle":0.5})"));
    EXPECT_EQ(std::get<SpotLight>(wide.lights.at(0)).falloff(std::cos(0.501)), 0);
    EXPECT_TRUE(warns(wide, "the outer cone is not wider than the inner: its edge is hard"));
}

/// Scales to nothing hide what hangs on a node, in animations above all.
TEST_F(GltfLights, without_a_direction_are_left_out) {
    std::string members = scene_of(R"("type":"spot")");
    const std::string place = R"("translation")";
    members.insert(members.find(place), R"("scale":[0,0,0],)");
    const SceneDescription scene = read(members);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(warns(scene, "is scaled to nothing: its light is left out"));
}

/// Each node that names a light has one; scales change neither its place nor its intensity.
TEST_F(GltfLights, may_be_shown_by_several_nodes) {
    const SceneDescription scene = read(R"("extensions":{"KHR_lights_punctual":{"lights":[
{"type":"point","intensity":683}]}},"scenes":[{"nodes":[0,1]}],
"nodes":[{"extensions":{"KHR_lights_punctual":{"light":0}}},
{"translation":[0,0,1],"scale":[2,2,2],"children":[2]},
{"translation":[1,0,0],"extensions":{"KHR_lights_punctual":{"light":0}}}])");
    ASSERT_EQ(scene.lights.size(), 2U);
    const auto& second = std::get<PointLight>(scene.lights[1]);
    EXPECT_EQ(second.position, Vec3d(2, 0, 1));
    EXPECT_NEAR(second.curve.luminance(), 1, 1e-4);
}

}  // namespace
}  // namespace sunfleck::engine
