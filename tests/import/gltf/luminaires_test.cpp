// Luminaires of glTF: candela in watts, turned with their nodes.
#include "import/gltf/luminaires.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::base64;
using testing_support::warns;

class GltfLuminaires : public testing_support::GltfFiles {
protected:
    /// One node with a luminaire of 683 cd at the nadir, 1366 at the horizon, 2049 at the zenith.
    static std::string scene_of(const std::string& node, const std::string& use = "") {
        const std::string file = "TILT=NONE\n1 -1 683 3 1 1 2 0 0 0\n1 1 0\n0 90 180\n0\n1 2 3\n";
        return R"("scenes":[{"nodes":[0]}],"nodes":[{"extensions":{"EXT_lights_ies":{"light":0)" +
               use + "}}" + node +
               R"(}],"extensions":{"EXT_lights_ies":{"lights":[{"name":"lamp","uri":"data:;base64,)" +
               base64(file) + R"("}]}})";
    }

    /// What a light brings in a direction at one metre.
    static double brought(const SceneDescription& scene, const Vec3d& w) {
        const auto& light = std::get<GoniometricLight>(scene.lights.at(0));
        const auto sample = light.sample_direct(Vec3(light.position + w), Vec2(0), {});
        return sample ? static_cast<double>(sample->factor * light.curve.luminance()) : 0;
    }
};

TEST_F(GltfLuminaires, shine_along_minus_z_in_watts) {
    const SceneDescription scene = read(scene_of(""));
    EXPECT_NEAR(brought(scene, {0, 0, -1}), 1, 0.01);
    EXPECT_NEAR(brought(scene, {1, 0, 0}), 2, 0.01);
    EXPECT_NEAR(brought(scene, {0, 0, 1}), 3, 0.01);
    EXPECT_EQ(scene.light_statements.at(0).what, "luminaire \"lamp\"");
    EXPECT_FALSE(warns(scene, "EXT_lights_ies"));
}

TEST_F(GltfLuminaires, turn_with_their_nodes_and_have_factors) {
    const SceneDescription scene =
        read(scene_of(R"(,"rotation":[0.70710678,0,0,0.70710678],"scale":[2,2,2])",
                      R"(,"multiplier":2,"color":[0.5,0.5,0.5])"));
    // A quarter turn around x takes -z to y.
    EXPECT_NEAR(brought(scene, {0, 1, 0}), 1, 0.01);
    EXPECT_NEAR(brought(scene, {0, -1, 0}), 3, 0.01);
}

TEST_F(GltfLuminaires, that_cannot_be_are_refused) {
    EXPECT_NE(fault_of(scene_of("", R"(,"multiplier":-1)")), "");
    EXPECT_NE(
        fault_of(
            R"("scenes":[{"nodes":[0]}],"nodes":[{"extensions":{"EXT_lights_ies":{"light":0}}}])"),
        "");
}

}  // namespace
}  // namespace sunfleck::engine
