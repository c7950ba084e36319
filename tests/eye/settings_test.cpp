// How wide discs are for indirect photons.
#include "eye/settings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck {
namespace {

TEST(IndirectReach, grows_with_the_picture) {
    EXPECT_DOUBLE_EQ(indirect_reach({}, {256, 256}), 2);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {1024, 64}), 2);
    EXPECT_DOUBLE_EQ(indirect_reach({}, {512, 512}), 2 * std::exp2(0.625));
    EXPECT_NEAR(indirect_reach({}, {1920, 1080}), 2 * std::pow(5.625, 0.625), 1e-12);
}

TEST(IndirectReach, is_not_less_than_one) {
    EXPECT_GT(indirect_reach({}, {86, 86}), 1);
    EXPECT_EQ(indirect_reach({}, {84, 84}), 1);
    EXPECT_EQ(indirect_reach({}, {1, 1}), 1);
}

TEST(IndirectReach, is_what_the_user_says) {
    EyeSettings settings;
    settings.indirect_radius = 7;
    EXPECT_EQ(indirect_reach(settings, {16, 12}), 7);
    EXPECT_EQ(indirect_reach(settings, {1920, 1080}), 7);
}

}  // namespace
}  // namespace sunfleck
