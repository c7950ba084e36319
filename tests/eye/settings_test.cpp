// How wide discs are for indirect photons.
#include "eye/settings.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

TEST(IndirectReach, is_a_60th_of_the_side_where_others_have_two_pixels) {
    EXPECT_DOUBLE_EQ(indirect_reach({}, {240, 240}), 2);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {480, 120}), 2);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {180, 180}), 1.5);
}

TEST(IndirectReach, is_one_to_three) {
    EXPECT_DOUBLE_EQ(indirect_reach({}, {16, 12}), 1);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {1, 1}), 1);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {1920, 1080}), 3);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {30'000, 30'000}), 3);
}

TEST(IndirectReach, is_what_the_user_says) {
    EyeSettings settings;
    settings.indirect_radius = 7;
    EXPECT_DOUBLE_EQ(indirect_reach(settings, {16, 12}), 7);
    EXPECT_DOUBLE_EQ(indirect_reach(settings, {1920, 1080}), 7);
}

}  // namespace
}  // namespace sunfleck
