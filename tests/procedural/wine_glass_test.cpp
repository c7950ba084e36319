// The wine glass scenes: one world, four views that close in; indices on the right surfaces.

#include "procedural/wine_glass.h"

#include "one_world.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace sunfleck::engine {
namespace {

TEST(WineGlass, all_views_show_the_same_world) {
    expect_one_world(kWineGlassViews, [](const CloseUp& view) { return wine_glass_scene(view); });
}

TEST(WineGlass, each_view_sees_a_third_of_the_width_of_the_one_before) {
    const auto width = [](const CloseUp& view) {
        return std::tan(std::stod(std::string(view.fov)) * 3.14159265358979 / 360);
    };
    for (std::size_t i = 1; i < kWineGlassViews.size(); ++i)
        EXPECT_NEAR(width(kWineGlassViews.at(i - 1)) / width(kWineGlassViews.at(i)), 3, 0.02);
}

/// Soda-lime glass; a white wine.
TEST(WineGlass, each_surface_has_the_ratio_of_its_two_media) {
    const std::vector<std::string> words =
        pbrt_words(wine_glass_scene(kWineGlassViews[0]).at(0).bytes);
    constexpr double kGlass = 1.5;
    constexpr double kWine = 1.345;
    EXPECT_NEAR(eta_of(words, "geometry/wine-glass.ply"), kGlass, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/wine-wall.ply"), kWine / kGlass, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/wine-level.ply"), kWine, 1e-7);
}

TEST(WineGlass, the_table_is_as_wide_as_the_constant_says) {
    const Mesh table = scene_meshes(wine_glass_scene(kWineGlassViews[1])).at(0);
    const auto side = static_cast<float>(kWineTableHalfWidth);
    EXPECT_EQ(table.points.at(2), (std::array<float, 3>{side, side, 0}));
    EXPECT_EQ(table.points.at(0), (std::array<float, 3>{-side, -side, 0}));
}

TEST(WineGlass, another_table_changes_nothing_else) {
    const Mesh small = square_mesh(45, 0);
    const std::vector<SceneFile> usual = wine_glass_scene(kWineGlassViews[1]);
    const std::vector<SceneFile> other = wine_glass_scene(kWineGlassViews[1], small);
    EXPECT_EQ(scene_meshes(other).at(0).points, small.points);
    std::string text = other.at(0).bytes;
    const std::string shape = shape_text(small);
    text.replace(text.find(shape), shape.size(), shape_text(wine_glass_table()));
    EXPECT_EQ(text, usual.at(0).bytes);
}

}  // namespace
}  // namespace sunfleck::engine
