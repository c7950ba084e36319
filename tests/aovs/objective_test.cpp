// What errors are divided by.
#include "aovs/objective.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Objective, relative_errors_are_over_the_brightness_there_or_a_tenth_of_the_pictures) {
    EXPECT_NEAR(squared_scale(Objective::relative, 50, 2), 50 * 50, 0.1);
    EXPECT_DOUBLE_EQ(squared_scale(Objective::relative, 0, 2), 0.2 * 0.2);
}

TEST(Objective, absolute_errors_are_over_the_brightness_of_the_picture) {
    EXPECT_EQ(squared_scale(Objective::absolute, 0, 2), 4);
    EXPECT_EQ(squared_scale(Objective::absolute, 50, 2), 4);
}

}  // namespace
}  // namespace sunfleck::engine
