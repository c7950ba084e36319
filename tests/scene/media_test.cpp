// Media of a scene: which of them a path is in, and what each leaves of light.
#include "scene/pass_scene.h"
#include "support/direct_light.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::floor_of;
using testing_support::quad;

constexpr std::uint32_t kInterface = 2;

/// Medium 1 absorbs 0.5, medium 2 absorbs 0.25, medium 3 nothing.
SceneDescription with_media(SceneDescription scene) {
    for (const float sigma : {0.5F, 0.25F, 0.0F})
        scene.media.all.push_back({Spectrum::constant(sigma), Spectrum(), 0});
    return scene;
}

/// Horizontal, normal up.
ShapeDescription sheet(float z, MediumSides media) {
    ShapeDescription shape =
        quad({{{-40, -40, z}, {40, -40, z}, {40, 40, z}, {-40, 40, z}}}, kInterface);
    shape.media = media;
    return shape;
}

Hit hit_below(const Scene& scene, float z) {
    return scene.geometry().intersect({{0.2F, 0.3F, z}, {0, 0, -1}, kInfinity}).value();
}

TEST(Media, absorb_by_wavelength) {
    SceneDescription description = floor_of();
    const Spectrum curve = Spectrum::rgb_unbounded({0.1F, 2, 5});
    description.media.all.push_back({curve, Spectrum(), 0});
    const Scene scene(description);
    for (std::uint32_t p = 0; p < 3; ++p) {
        const PassScene pass(scene, {1, p});
        const SampledSpectrum sigma = curve.at(pass.wavelengths);
        const SampledSpectrum left = pass.transmittance(1, {Vec3(0), Vec3(0, 0, 1), 0.3F});
        for (std::size_t i = 0; i < kWavelengths; ++i)
            EXPECT_FLOAT_EQ(left[i], std::exp(-0.3F * sigma[i]));
    }
}

TEST(Media, change_at_surfaces_that_part_them) {
    SceneDescription description = with_media(floor_of());
    description.shapes.push_back(sheet(1, {1, 2}));
    description.shapes.push_back(sheet(2, {3, 3}));
    description.shapes.push_back(sheet(3, {0, 1}));
    const Scene scene(description);
    const Hit upper = hit_below(scene, 4);  // the sheet at 2 is nothing at all
    EXPECT_FLOAT_EQ(upper.position.z, 3);
    EXPECT_EQ(scene.medium_beyond(upper, {0, 0, 1}, 3), 1U);
    EXPECT_EQ(scene.medium_beyond(upper, {0, 0, -1}, 3), 0U);
    const Hit lower = hit_below(scene, 2.5F);
    EXPECT_FLOAT_EQ(lower.position.z, 1);
    EXPECT_EQ(scene.medium_beyond(lower, {0, 0, 1}, 0), 2U);
    const Hit floor = hit_below(scene, 0.5F);
    EXPECT_EQ(scene.medium_beyond(floor, {0, 0, 1}, 2), 2U);
}

/// Through 1 m of medium 1 and 0.5 m of medium 2.
TEST(Media, shadow_rays_pass_them) {
    SceneDescription description = with_media(floor_of());
    description.shapes.push_back(sheet(1, {1, 2}));
    description.shapes.push_back(sheet(2, {2, 0}));
    const Scene scene(description);
    const PassScene pass(scene, {1, 0});
    const Hit floor = hit_below(scene, 0.5F);
    const auto seen = [&](float distance) {
        return pass.seen_from(floor, {0, 0, 1}, distance, 1)[0];
    };
    EXPECT_NEAR(seen(0.5F), std::exp(-0.25F), 1e-6F);
    EXPECT_NEAR(seen(1.5F), std::exp(-0.625F), 1e-6F);
    EXPECT_NEAR(seen(7), std::exp(-0.75F), 1e-6F);
    EXPECT_NEAR(seen(kInfinity), std::exp(-0.75F), 1e-6F);
    SceneDescription covered = description;
    covered.shapes.push_back(quad({{{-9, -9, 3}, {9, -9, 3}, {9, 9, 3}, {-9, 9, 3}}}));
    const Scene dark(covered);
    const PassScene dark_pass(dark, {1, 0});
    EXPECT_TRUE(dark_pass.seen_from(floor, {0, 0, 1}, kInfinity, 1).is_zero());
    EXPECT_FALSE(dark_pass.seen_from(floor, {0, 0, 1}, 2.5F, 1).is_zero());
}

/// Media that all let light pass leave a scene as it would be without them.
TEST(Media, that_absorb_nothing_are_none) {
    SceneDescription description = floor_of();
    description.media.all.push_back({Spectrum::constant(0), Spectrum(), 0});
    description.shapes.push_back(sheet(1, {1, 0}));
    const Scene scene(description);
    EXPECT_FALSE(scene.has_media());
    EXPECT_FLOAT_EQ(hit_below(scene, 4).position.z, 0);
}

/// No path enters what is behind them, whatever they name.
TEST(Media, are_not_parted_by_what_lets_no_light_through) {
    SceneDescription description = with_media(floor_of());
    ShapeDescription wall = sheet(1, {1, 2});
    wall.material = 0;
    description.shapes.push_back(wall);
    const Scene scene(description);
    const Hit hit = hit_below(scene, 4);
    EXPECT_FALSE(scene.separates_media(hit));
    EXPECT_EQ(scene.medium_beyond(hit, {0, 0, 1}, 3), 3U);
    EXPECT_EQ(scene.medium_beyond(hit, {0, 0, -1}, 3), 3U);
}

/// Lamps stand in the medium of their side; lights from afar in what surrounds everything.
TEST(Media, around_lights) {
    SceneDescription description = with_media(floor_of());
    auto& camera = std::get<PerspectiveCamera>(description.camera);
    camera.camera_to_world.setTranslation(Vec3d(0, 0, 1));
    description.shapes.push_back(sheet(2, {2, 1}));
    ShapeDescription lamp = testing_support::lamp(sheet(-1, {2, 1}), 1);
    lamp.material = 0;
    description.shapes.push_back(lamp);
    description.lights = {PointLight{Spectrum::constant(1), {0, 0, 1}},
                          DistantLight{Spectrum::constant(1), {0, 0, -1}}, InfiniteLight{}};
    description.media.at_lights = {{3, 3}};
    description.media.at_camera = 2;
    const Scene scene(description);
    const auto at = [&](std::size_t light, float z) {
        return scene.media().at_lights[light].towards({0, 0, 1}, {0, 0, z});
    };
    EXPECT_EQ(at(0, 1), 1U);
    EXPECT_EQ(at(1, -1), 2U);
    EXPECT_EQ(at(2, 1), 3U);
    EXPECT_EQ(at(3, 1), 1U);
    EXPECT_EQ(at(4, 1), 1U);
    EXPECT_EQ(scene.outer_medium(), 1U);
}

}  // namespace
}  // namespace sunfleck::engine
