// A scene of calls is the scene of a file that says the same.
#include "library/support.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

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

/// Numbers of any type; strings as a list.
TEST(Value, takes_the_numbers_and_lists_of_a_program) {
    using Numbers = std::vector<double>;
    using Whole = std::vector<std::int32_t>;
    using Texts = std::vector<std::string>;
    const auto numbers = [](const Value& value) { return std::get<Numbers>(value.data()); };
    const auto whole = [](const Value& value) { return std::get<Whole>(value.data()); };
    EXPECT_EQ(numbers(0.5F), Numbers{0.5});
    EXPECT_EQ(numbers(std::vector<float>{1, 2}), (Numbers{1, 2}));
    EXPECT_EQ(numbers(std::array<double, 2>{3, 4}), (Numbers{3, 4}));
    EXPECT_EQ(numbers({0, 0, 0}), (Numbers{0, 0, 0}));
    EXPECT_EQ(whole(3), Whole{3});
    EXPECT_EQ(whole(3U), Whole{3});
    EXPECT_EQ(whole(-10L), Whole{-10});
    EXPECT_EQ(whole(std::vector<std::size_t>{7, 8}), (Whole{7, 8}));
    EXPECT_EQ(numbers(std::int64_t{1} << 40U), Numbers{0x1p40});
    EXPECT_EQ(numbers(3'000'000'000U), Numbers{3e9});
    EXPECT_EQ(std::get<Texts>(Value{"a", "b"}.data()), (Texts{"a", "b"}));
    EXPECT_EQ(std::get<Texts>(Value(std::string_view("a")).data()), Texts{"a"});
    EXPECT_EQ(std::get<Texts>(Value("a").data()), Texts{"a"});
    EXPECT_TRUE(std::get<bool>(Value(true).data()));
}

bool tells(const std::string& fault, const std::string& word) {
    return fault.find(word) != std::string::npos;
}

TEST(SceneBuilder, tells_of_types_and_values_in_the_call) {
    SceneBuilder builder;
    const Transform here;
    EXPECT_TRUE(tells(fault_of([&] { builder.camera("fisheye", {}, here); }), "fisheye"));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.camera("perspective", {{"float fov", 0}}, here);
                      }),
                      "\"fov\""));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.camera("perspective", {{"float shutterclose", 0}}, here);
                      }),
                      "shutter"));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.camera("perspective", {}, Transform::translate({1e39, 0, 0}));
                      }),
                      "3.4e38"));
    EXPECT_TRUE(tells(fault_of([&] { builder.film(0, 3); }), "film"));
    EXPECT_TRUE(tells(fault_of([&] { builder.film(3, 3, {{"float iso", -1}}); }), "\"iso\""));
    EXPECT_TRUE(tells(fault_of([&] { builder.filter("cone"); }), "cone"));
    EXPECT_TRUE(tells(fault_of([&] { builder.medium("fog", "thick"); }), "thick"));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.medium("fog", "homogeneous", {{"float scale", -1}});
                      }),
                      "\"scale\""));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.material("m", "dielectric", {{"float eta", -1}});
                      }),
                      "not positive"));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.texture("t", "float", "checkerboard", {{"integer dimension", 4}});
                      }),
                      "4 dimensions"));
    EXPECT_EQ(builder.build().width(), 1280);  // nothing was taken
}

TEST(SceneBuilder, leaves_to_the_end_what_may_still_come) {
    SceneBuilder builder("no/such/folder");
    builder.camera("perspective", {}, {}, "fog");
    builder.camera("perspective", {}, {});
    builder.material("board", "diffuse", {{"texture reflectance", "wood"}});
    builder.material("wall", "diffuse", {{"string normalmap", "wall.png"}});
    builder.material("both", "mix", {{"string materials", {"a", "b"}}});
    builder.texture("wood", "spectrum", "imagemap", {{"string filename", "wood.png"}});
    EXPECT_EQ(fault_of([&] { builder.build(); }), "");
}

TEST(SceneBuilder, is_unchanged_by_a_call_that_throws) {
    SceneBuilder builder = ball_builder();
    const Scene before = ball_builder().build();
    const ShapeOptions lamp{.material = "never",
                            .area_light = Parameters{{"rgb L", {1, 1, 1}}},
                            .inside_medium = "never",
                            .outside_medium = "never",
                            .object = "never"};
    const std::array<float, 9> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<std::uint32_t, 3> triangle = {0, 1, 3};
    EXPECT_NE(fault_of([&] { builder.shape("sphere", {{"float radius", -1}}, lamp); }), "");
    EXPECT_NE(fault_of([&] { builder.mesh({corners, triangle}, lamp); }), "");
    EXPECT_NE(fault_of([&] {
                  builder.shape("sphere", {{"texture alpha", "never"}, {"float odd", 1}}, lamp);
              }),
              "");
    EXPECT_NE(fault_of([&] { builder.light("spot", {{"float coneangle", 0}}, {}, "never"); }), "");
    EXPECT_NE(fault_of([&] {
                  builder.material("never", "diffuse", {{"rgb reflectance", 1}});
              }),
              "");
    const Scene after = builder.build();
    EXPECT_EQ(after.warnings(), before.warnings());
    ASSERT_EQ(after.lights().size(), before.lights().size());
    for (std::size_t i = 0; i < before.lights().size(); ++i)
        EXPECT_EQ(after.lights()[i].where, before.lights()[i].where);
    SceneBuilder other;
    EXPECT_NE(fault_of([&] {
                  other.shape("sphere", {{"float radius", -1}}, {.object = "o"});
              }),
              "");
    other.instance("o");
    EXPECT_TRUE(tells(fault_of([&] { other.build(); }), "there is no object \"o\""));
}

TEST(SceneBuilder, can_be_mended_after_a_build_that_failed) {
    SceneBuilder builder = ball_builder();
    builder.texture("spots", "spectrum", "dots", {{"rgb inside", {1, 0, 0}}, {"float odd", 1}});
    builder.material("spotted", "diffuse", {{"texture reflectance", "spots"}, {"float odd", 2}});
    builder.shape("sphere", {}, {.material = "spotted"});
    builder.shape("disk", {}, {.material = "late"});
    builder.instance("stool");
    EXPECT_TRUE(tells(fault_of([&] { builder.build(); }), "there is no material \"late\""));
    builder.material("late", "diffuse");
    EXPECT_TRUE(tells(fault_of([&] { builder.build(); }), "there is no object \"stool\""));
    builder.shape("sphere", {}, {.object = "stool"});
    const Scene scene = builder.build();
    EXPECT_EQ(scene.triangle_count(), 2U);
    EXPECT_EQ(scene.width(), 24);
    ASSERT_EQ(scene.warnings().size(), 2U);
    for (const std::string& warning : scene.warnings()) EXPECT_FALSE(tells(warning, "times"));
}

TEST(SceneBuilder, tells_what_files_are_still_missing_in_each_build) {
    SceneBuilder builder("no/such/folder");
    builder.texture("wood", "spectrum", "imagemap", {{"string filename", "wood.png"}});
    builder.material("board", "diffuse", {{"texture reflectance", "wood"}});
    builder.shape("sphere", {}, {.material = "board"});
    const std::string fault = fault_of([&] { builder.build(); });
    EXPECT_TRUE(tells(fault, "wood.png"));
    EXPECT_EQ(fault_of([&] { builder.build(); }), fault);
}

TEST(SceneBuilder, is_as_if_new_after_a_move) {
    SceneBuilder builder = ball_builder();
    const SceneBuilder taken = std::move(builder);
    builder.film(3, 2);  // NOLINT(bugprone-use-after-move): the subject of the test
    EXPECT_EQ(builder.build().width(), 3);
    SceneBuilder another;
    SceneBuilder third = std::move(another);
    // NOLINTNEXTLINE(bugprone-use-after-move): the subject of the test
    EXPECT_EQ(another.build().triangle_count(), 0U);
}

TEST(SceneBuilder, mends_by_what_a_program_can_do) {
    for (const auto& [options, word] :
         {std::pair(ShapeOptions{.material = "x"}, "make the material"),
          std::pair(ShapeOptions{.inside_medium = "x"}, "make the medium")}) {
        SceneBuilder builder;
        builder.shape("sphere", {}, options);
        const std::string fault = fault_of([&] { builder.build(); });
        EXPECT_TRUE(tells(fault, word) && !tells(fault, "MakeNamed")) << fault;
    }
    SceneBuilder builder;
    builder.instance("x");
    EXPECT_TRUE(tells(fault_of([&] { builder.build(); }), "make the object"));
    EXPECT_TRUE(tells(fault_of([&] {
                          builder.shape("sphere", {{"texture alpha", "x"}});
                      }),
                      "make the texture before"));
}

TEST(Scene, names_the_files_that_were_read) {
    EXPECT_TRUE(ball_builder().build().files().empty());
    EXPECT_TRUE(Scene::parse(kBall, "ball.pbrt").files().empty());
    EXPECT_TRUE(tells(fault_of([] { Scene::load(""); }), "empty"));
}

}  // namespace
}  // namespace sunfleck
