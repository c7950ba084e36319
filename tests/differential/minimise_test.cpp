// The minimiser, on oracles that are made up: it keeps what matters and nothing else.
#include "differential/minimise.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::differential {
namespace {

SceneText example() {
    SceneText scene;
    scene.options.statements = {{"Camera", {"fov"}, false}, {"Film", {"size"}, true}};
    scene.world = {{true, {{"LightSource", {"I", "from"}, false}}},
                   {true, {{"Material", {"eta", "roughness"}, false}, {"Shape", {"alpha"}, false}}},
                   {true, {{"Shape", {}, false}}}};
    return scene;
}

bool holds(const SceneText& scene, const std::string& word) {
    return text_of(scene).find(word) != std::string::npos;
}

TEST(Minimise, keeps_what_the_fault_needs_and_nothing_else) {
    const auto fails = [](const SceneText& scene) {
        return holds(scene, "LightSource") && holds(scene, "Material roughness");
    };
    // "Material roughness" appears once eta is gone; until then the fault is that of both.
    const auto fails_in_any = [&](const SceneText& scene) {
        return holds(scene, "LightSource") && holds(scene, "roughness");
    };
    const SceneText small = minimised(example(), fails_in_any, 1000);
    EXPECT_EQ(text_of(small),
              "Film size\nWorldBegin\nAttributeBegin\n  LightSource\nAttributeEnd\n"
              "AttributeBegin\n  Material roughness\nAttributeEnd\n");
    EXPECT_TRUE(fails(small));
}

TEST(Minimise, kept_statements_stay_with_their_parameters) {
    const SceneText small = minimised(
        example(), [](const SceneText&) { return true; }, 1000);
    EXPECT_EQ(text_of(small), "Film size\nWorldBegin\n");
}

TEST(Minimise, what_cannot_go_alone_leaves_the_scene_as_it_was) {
    EXPECT_EQ(minimised(
                  example(), [](const SceneText&) { return false; }, 1000),
              example());
}

TEST(Minimise, what_goes_only_after_something_else_goes_in_a_later_round) {
    const auto fails = [](const SceneText& scene) {  // the light may go once no shape is there
        return holds(scene, "Camera") && (holds(scene, "LightSource") || !holds(scene, "Shape"));
    };
    EXPECT_EQ(text_of(minimised(example(), fails, 1000)), "Camera\nFilm size\nWorldBegin\n");
}

TEST(Minimise, asks_no_more_often_than_it_may) {
    int asked = 0;
    minimised(
        example(), [&](const SceneText&) { return ++asked > 0; }, 3);
    EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace sunfleck::engine::differential
