// A scene of calls is the scene of a file that says the same.
#include "library/support.h"

#include <gtest/gtest.h>

#include <array>

namespace sunfleck {
namespace {

using testing_support::kBall;
using testing_support::quick_settings;
using testing_support::rendered;

SceneBuilder ball_builder() {
    SceneBuilder builder;
    builder.camera("perspective", {{"float fov", 35}},
                   Transform::look_at({0, -6, 4}, {0, 0, 0.6}, {0, 0, 1}));
    builder.film(24, 16);
    builder.material("table", "diffuse", {{"rgb reflectance", {0.6, 0.5, 0.4}}});
    builder.material("glass", "dielectric", {{"float eta", 1.5}});
    const std::array<float, 12> corners = {-4, -4, 0, 4, -4, 0, 4, 4, 0, -4, 4, 0};
    const std::array<std::uint32_t, 6> triangles = {0, 1, 2, 0, 2, 3};
    builder.mesh({corners, triangles}, {.material = "table"});
    builder.shape("sphere", {{"float radius", 1}},
                  {.material = "glass", .to_world = Transform::translate({0, 0, 1.2})});
    builder.shape("sphere", {{"float radius", 0.1}},
                  {.material = "table",
                   .to_world = Transform::translate({-2, 1, 5}),
                   .area_light = Parameters{{"rgb L", {900, 800, 650}}}});
    return builder;
}

template <class Call>
std::string fault_of(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SceneBuilder, makes_the_scene_of_a_file_that_says_the_same) {
    const Scene by_calls = ball_builder().build();
    EXPECT_TRUE(by_calls.warnings().empty());
    EXPECT_EQ(rendered(by_calls, quick_settings()),
              rendered(Scene::parse(kBall, "ball.pbrt"), quick_settings()));
}

TEST(SceneBuilder, places_objects_by_instances_that_may_come_first) {
    SceneBuilder builder = ball_builder();
    builder.instance("stool", Transform::translate({1, 0, 0}));
    builder.instance("stool", Transform::translate({-1, 0, 0}));
    builder.shape("disk", {{"float height", 0.5}}, {.object = "stool"});
    builder.shape("cylinder", {{"float radius", 0.1}}, {.object = "stool"});
    EXPECT_EQ(builder.build().triangle_count(), 2U);
    EXPECT_NE(fault_of([] {
                  SceneBuilder other = ball_builder();
                  other.instance("chair");
                  other.build();
              }).find("chair"),
              std::string::npos);
}

TEST(SceneBuilder, names_the_call_that_cannot_be) {
    SceneBuilder builder;
    EXPECT_NE(fault_of([&] {
                  builder.shape("sphere", {{"float radius", -1}});
              }).find("shape 1"),
              std::string::npos);
    EXPECT_NE(fault_of([&] { builder.shape("ball", {}); }).find("unknown shape \"ball\""),
              std::string::npos);
    EXPECT_NE(fault_of([&] {
                  builder.shape("sphere", {{"float radius", "big"}});
              }).find("number"),
              std::string::npos);
    EXPECT_NE(fault_of([&] { builder.material("a", "glas"); }).find("glas"), std::string::npos);
    EXPECT_NE(fault_of([&] {
                  builder.light("point", {{"colour I", 1}});
              }).find("\"colour I\""),
              std::string::npos);
    const std::array<float, 9> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<std::uint32_t, 3> triangle = {0, 1, 3};
    EXPECT_NE(fault_of([&] {
                  builder.mesh({corners, triangle});
              }).find("vertex 3"),
              std::string::npos);
}

TEST(SceneBuilder, tells_all_missing_files_at_once) {
    SceneBuilder builder("no/such/folder");
    builder.texture("wood", "spectrum", "imagemap", {{"string filename", "wood.png"}});
    builder.material("board", "diffuse", {{"texture reflectance", "wood"}});
    builder.shape("sphere", {}, {.material = "board"});
    builder.shape("plymesh", {{"string filename", "chair.ply"}});
    const std::string fault = fault_of([&] { builder.build(); });
    EXPECT_NE(fault.find("wood.png"), std::string::npos) << fault;
    EXPECT_NE(fault.find("chair.ply"), std::string::npos) << fault;
}

TEST(SceneBuilder, is_empty_after_build) {
    SceneBuilder builder = ball_builder();
    builder.build();
    EXPECT_EQ(builder.build().triangle_count(), 0U);
}

}  // namespace
}  // namespace sunfleck
