// Scenes from choices: the same ones each time, with what was chosen in them.
#include "differential/make_scene.h"

#include "differential/covering.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine::differential {
namespace {

/// A choice with these values, and the first ones else.
Choice with(const FeatureTable& table,
            const std::vector<std::pair<std::string, std::string>>& values) {
    Choice choice(table.size(), 0);
    for (const auto& [name, value] : values) {
        const std::size_t index = table.index_of(name);
        const auto& known = table[index].values;
        choice[index] =
            static_cast<Value>(std::find(known.begin(), known.end(), value) - known.begin());
    }
    return choice;
}

TEST(MakeScene, a_number_gives_the_same_scene_and_another_one_another) {
    const FeatureTable table = scene_features();
    const Choice choice(table.size(), 0);
    EXPECT_EQ(make_scene(table, choice, 1, 7), make_scene(table, choice, 1, 7));
    EXPECT_NE(make_scene(table, choice, 1, 7), make_scene(table, choice, 1, 8));
    EXPECT_NE(make_scene(table, choice, 1, 7), make_scene(table, choice, 2, 7));
}

TEST(MakeScene, what_is_chosen_stands_in_the_scene) {
    const FeatureTable table = scene_features();
    const std::string text = text_of(make_scene(table,
                                                with(table, {{"light", "area"},
                                                             {"lamp shape", "cylinder"},
                                                             {"material", "dielectric"},
                                                             {"inner medium", "amber"},
                                                             {"instances", "two"},
                                                             {"filter", "mitchell"}}),
                                                0, 0));
    for (const char* word : {"AreaLightSource \"diffuse\"", "Shape \"cylinder\"", "\"dielectric\"",
                             "MediumInterface \"amber\"", "ObjectInstance", "\"mitchell\""})
        EXPECT_NE(text.find(word), std::string::npos) << word << '\n' << text;
}

/// A point's light through smooth glass ends on a surface that no path from the camera connects.
TEST(MakeScene, references_are_those_that_find_all_light) {
    const FeatureTable table = scene_features();
    const auto by_path = [&](const char* light, const char* beside) {
        return is_found_by_path(table, with(table, {{"light", light}, {"beside", beside}}));
    };
    EXPECT_FALSE(by_path("point", "glass ball"));
    EXPECT_TRUE(by_path("point", "diffuse ball"));
    EXPECT_TRUE(by_path("area", "glass ball"));
}

}  // namespace
}  // namespace sunfleck::engine::differential
