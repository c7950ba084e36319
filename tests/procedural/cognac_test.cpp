// The cognac scenes: one scene, seven looks; indices of refraction on the right surfaces.

#include "procedural/cognac.h"

#include "one_world.h"
#include "procedural/cognac_glass.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Cognac, all_views_show_the_same_world) {
    expect_one_world(kCognacViews, [](const CloseUp& view) { return cognac_scene(view); });
}

TEST(Cognac, the_views_close_in) {
    const auto fov = [](std::size_t i) { return std::stod(std::string(kCognacViews.at(i).fov)); };
    for (const std::size_t i : {1U, 2U, 4U, 5U, 6U}) EXPECT_LT(fov(i), fov(i == 4 ? 2 : i - 1));
    EXPECT_NE(kCognacViews[3].target, kCognacViews[2].target);
}

/// Soda-lime glass; ethanol at 40% in water.
TEST(Cognac, each_surface_has_the_ratio_of_its_two_media) {
    const std::vector<std::string> words = pbrt_words(cognac_scene(kCognacViews[0]).at(0).bytes);
    constexpr double kGlass = 1.5;
    constexpr double kBrandy = 1.36;
    EXPECT_NEAR(eta_of(words, "geometry/glass-air.ply"), kGlass, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/brandy-glass.ply"), kBrandy / kGlass, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/brandy-air.ply"), kBrandy, 1e-7);
}

TEST(Cognac, each_file_holds_its_surface) {
    const std::vector<SceneFile> files = cognac_scene(kCognacViews[0]);
    const CognacGlass glass = cognac_glass();
    EXPECT_EQ(files.at(1).bytes, ply_bytes(glass.glass_air));
    EXPECT_EQ(files.at(2).bytes, ply_bytes(glass.liquid_glass));
    EXPECT_EQ(files.at(3).bytes, ply_bytes(glass.liquid_air));
}

TEST(Cognac, the_table_is_as_wide_as_the_constant_says) {
    const Mesh table = scene_meshes(cognac_scene(kCognacViews[0])).at(0);
    const auto side = static_cast<float>(kTableHalfWidth);
    EXPECT_EQ(table.triangles.size(), 2);
    EXPECT_EQ(table.points.at(2), (std::array<float, 3>{side, side, 0}));
    EXPECT_EQ(table.points.at(0), (std::array<float, 3>{-side, -side, 0}));
}

}  // namespace
}  // namespace sunfleck::engine
