// The AOVs that a camera pass brings, under a limit of depth.
#include "camera_paths/trace_camera_paths.h"

#include "support/direct_light_cases.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// Luminance of one AOV over pixels that all look at kPoint from straight above.
double aov_of(SceneDescription scene, int max_depth, Aov aov) {
    constexpr int kSide = 8;
    constexpr std::uint32_t kPasses = 64;
    scene.film.resolution = Vec2i(kSide, kSide);
    const Matrix camera(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, kPoint.x, kPoint.y, 1.5, 1);
    scene.camera = make_perspective(camera, scene.film.resolution, 0.01, 1, {});
    scene.filter = {FilterKind::box, {0.5, 0.5}};
    const Scene built(std::move(scene));
    double sum = 0;
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        AovSet all;
        all.fill(true);
        PassImage image(kSide * kSide, all);
        Statistics statistics;
        const PassId id{4, pass};
        const PassScene at(built, id);
        trace_camera_paths({at, {DirectLight::sampled, max_depth}, {}, {0, 0, kSide, kSide}, id, 1},
                           image, statistics);
        constexpr std::array<double, 3> kLuminance = {0.2126, 0.7152, 0.0722};
        for (std::size_t i = 0; i < image.pixels(); ++i)
            for (const std::size_t c : {0U, 1U, 2U})
                sum += kLuminance.at(c) * image.value(aov, i, c).to_double();
    }
    return sum / (kPasses * kSide * kSide);
}

/// One scattering event is all that direct light needs; each glass before it takes one more.
TEST(CameraPass, direct_light_and_max_depth) {
    for (const std::uint32_t material : {0U, 1U}) {
        SceneDescription scene = floor_of(material);
        scene.shapes.push_back(lamp(quad(kCeiling), 2));
        const double expected = from_lamp(LitPoint(scene, {0, 0, -1}).vertex(), 2);
        EXPECT_EQ(aov_of(scene, 0, Aov::direct), 0);
        const double once = aov_of(scene, 1, Aov::direct);
        EXPECT_NEAR(once / expected, 1, 0.01) << material;
        EXPECT_EQ(aov_of(scene, 2, Aov::direct), once);
        EXPECT_EQ(aov_of(scene, 1, Aov::indirect), 0);
        scene.shapes.push_back(quad(
            {{{.2F, -.3F, 1.4F}, {.4F, -.3F, 1.4F}, {.4F, -.1F, 1.4F}, {.2F, -.1F, 1.4F}}}, 3));
        EXPECT_EQ(aov_of(scene, 1, Aov::direct), 0);
        EXPECT_GT(aov_of(scene, 2, Aov::direct), 0.0);
    }
}

}  // namespace
}  // namespace sunfleck::engine
