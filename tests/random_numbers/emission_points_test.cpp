// Emission points: each path uniform by itself, evenly spread within a pass, fresh each pass.
#include "random_numbers/emission_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace sunfleck::engine {
namespace {

TEST(EmissionPoints, same_dimension_same_number) {
    const EmissionPoints points({7, 3});
    auto once = points.path(11);
    auto again = points.path(11);
    for (const std::uint32_t i : {0U, 9U, 4U, 200U, 9U}) EXPECT_EQ(once(i), again(i));
}

TEST(EmissionPoints, paths_of_a_pass_fill_the_cells) {
    const EmissionPoints points({7, 3});
    for (std::uint32_t dimension = 0; dimension < kSobolDimensions; ++dimension) {
        std::set<std::uint64_t> cells;
        for (std::uint32_t i = 0; i < 256; ++i) cells.insert(points.path(i)(dimension) >> 56U);
        EXPECT_EQ(cells.size(), 256U);
    }
}

// Path 5 over 40,000 passes: mean 1/2 within 4 standard errors (seed 1; sees a shift of 0.006).
TEST(EmissionPoints, one_path_is_uniform_over_passes) {
    constexpr std::uint32_t kPasses = 40000;
    double sum = 0;
    double sum_of_squares = 0;
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        const EmissionPoints points({1, pass});
        const double u = to_unit(points.path(5)(dimension(EmissionDimension::direction_v)));
        sum += u;
        sum_of_squares += u * u;
    }
    const double error = std::sqrt(1.0 / 12 / kPasses);
    EXPECT_NEAR(sum / kPasses, 0.5, 4 * error);
    EXPECT_NEAR(sum_of_squares / kPasses, 1.0 / 3, 4 * error);
}

// Dimensions of paths from Sobol' points and of independent ones: no two have the same highest 32
// bits.
TEST(EmissionPoints, every_dimension_has_numbers_of_its_own) {
    const PassId pass{7, 3};
    std::set<std::uint64_t> seen;
    constexpr std::uint32_t kDimensions = 50;
    for (const std::uint32_t number : {0U, 1U}) {
        auto even = EmissionPoints(pass).path(number);
        for (std::uint32_t i = 0; i < kDimensions; ++i) seen.insert(even(i) >> 32U);
        auto independent = IndependentPoints(pass.with_part(1)).path(number);
        for (std::uint32_t i = 0; i < kDimensions; ++i) seen.insert(independent(i) >> 32U);
    }
    EXPECT_EQ(seen.size(), 4 * kDimensions);
}

// The error of a pass's mean of an indicator falls faster than independent numbers allow, and the
// mean over passes converges: a shift that stood still would leave the same error in every pass.
TEST(EmissionPoints, fresh_shift_each_pass) {
    double previous = -1;
    for (std::uint32_t pass = 0; pass < 8; ++pass) {
        const EmissionPoints points({1, pass});
        const double first = to_unit(points.path(0)(0));
        EXPECT_NE(first, previous);
        previous = first;
    }
}

}  // namespace
}  // namespace sunfleck::engine
