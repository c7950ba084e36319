// Pairs of feature values: which can occur, which have occurred, and that choices cover them all.
#include "differential/covering.h"

#include "sunfleck/error.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::differential {
namespace {

/// A lamp has a shape only where it is an area light, and a shape a side only where it is a disk.
FeatureTable small_table() {
    return FeatureTable({{"light", {"point", "area"}, {}},
                         {"shape", {"disk", "sphere"}, {{"light", {"area"}}}},
                         {"side", {"up", "down"}, {{"shape", {"disk"}}}},
                         {"film", {"small", "large"}, {}}});
}

TEST(GuideCoverage, pairs_without_a_meaning_are_not_asked_for) {
    const FeatureTable table = small_table();
    // light-shape 2, light-side 2, light-film 4, shape-side 2, shape-film 4, side-film 4.
    EXPECT_EQ(PairCoverage(table).possible(), 18U);
}

TEST(GuideCoverage, a_value_without_a_meaning_covers_no_pair) {
    const FeatureTable table = small_table();
    PairCoverage coverage(table);
    coverage.add({0, 0, 0, 0});  // a point light: its shape says nothing
    EXPECT_EQ(coverage.covered(), 1U);
    coverage.add({0, 1, 1, 0});
    EXPECT_EQ(coverage.covered(), 1U);
    coverage.add({1, 0, 0, 0});
    EXPECT_EQ(coverage.covered(), 7U);
    EXPECT_EQ(coverage.missing().size(), 11U);
}

TEST(GuideCoverage, what_a_need_needs_is_needed_too) {
    const FeatureTable table = small_table();
    EXPECT_FALSE(table.has_meaning({0, 0, 1, 0}, 2));
    EXPECT_EQ(table.value({0, 0, 1, 0}, "side"), "");
    EXPECT_EQ(table.value({1, 0, 1, 0}, "side"), "down");
}

TEST(GuideCoverage, a_name_that_is_not_in_the_table_is_an_error) {
    EXPECT_THROW(FeatureTable({{"shape", {"disk"}, {{"lamp", {"area"}}}}}), Error);
    EXPECT_THROW(scene_features({"shape=cube"}), Error);
}

TEST(GuideCoverage, all_pairs_of_the_scene_language_in_few_scenes) {
    const FeatureTable table = scene_features();
    CoveringChoices choices(table, 1);
    PairCoverage coverage(table);
    for (int i = 0; i < 330; ++i) coverage.add(choices.next());
    EXPECT_TRUE(coverage.missing().empty());
}

TEST(GuideCoverage, a_seed_gives_the_same_choices_and_another_one_others) {
    const FeatureTable table = small_table();
    const auto of_seed = [&](std::uint64_t seed) {
        CoveringChoices choices(table, seed);
        std::vector<Choice> all;
        all.reserve(20);
        for (int i = 0; i < 20; ++i) all.push_back(choices.next());
        return all;
    };
    EXPECT_EQ(of_seed(1), of_seed(1));
    EXPECT_NE(of_seed(1), of_seed(2));
}

}  // namespace
}  // namespace sunfleck::engine::differential
