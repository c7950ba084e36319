// Student's t against closed forms and tables.
#include "math/student.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sunfleck::engine {
namespace {

TEST(Student, quantiles_of_one_and_two_degrees_are_closed_forms) {
    for (const double within : {0.5, 0.8, 0.95, 0.99}) {
        const double one = std::tan(std::numbers::pi / 2 * within);
        const double two = within * std::sqrt(2 / (1 - within * within));
        EXPECT_NEAR(student_quantile(within, 1) / one, 1, 1e-4);
        EXPECT_NEAR(student_quantile(within, 2) / two, 1, 1e-4);
    }
}

TEST(Student, quantiles_are_those_of_tables) {
    EXPECT_NEAR(student_quantile(0.95, 3), 3.182, 1e-3);
    EXPECT_NEAR(student_quantile(0.99, 7), 3.499, 1e-3);
    EXPECT_NEAR(student_quantile(0.95, 30), 2.042, 1e-3);
    EXPECT_NEAR(student_quantile(0.95, 1e5), 1.960, 1e-3);
}

TEST(Student, between_whole_degrees_the_quantile_falls) {
    double last = student_quantile(0.95, 1);
    for (double degrees = 1.1; degrees < 4; degrees += 0.1) {
        EXPECT_LT(student_quantile(0.95, degrees), last);
        last = student_quantile(0.95, degrees);
    }
}

TEST(Student, nothing_is_widened_where_the_error_is_known) {
    EXPECT_NEAR(student_widening(1), 6.984, 1e-2);
    EXPECT_NEAR(student_widening(1e9), 1, 1e-3);
}

}  // namespace
}  // namespace sunfleck::engine
