// Spots in pictures whose spots are known.
#include "compare/spots.h"

#include <gtest/gtest.h>

#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kWidth = 50;
using Pixels = std::vector<double>;

TEST(Spots, a_pixel_thrice_as_bright_as_all_around_it_is_one) {
    const Pixels reference(kWidth * 40, 1);
    Pixels pixels = reference;
    pixels[3 * kWidth + 7] = 3.1;
    pixels[kWidth * 40 - 1] = 9;  // in a corner
    pixels[20 * kWidth + 20] = 2.9;
    EXPECT_EQ(spots_of(reference, pixels, kWidth).count, 2U);
    EXPECT_EQ(spots_of(reference, reference, kWidth).count, 0U);
}

/// Two pixels away the reference is as bright: no spot. Three away: one.
TEST(Spots, light_of_the_reference_two_pixels_away_excuses_it) {
    for (const std::size_t away : {2U, 3U}) {
        Pixels reference(kWidth * 40, 0.1);
        reference[20 * kWidth + 20 + away] = 5;
        Pixels pixels = reference;
        pixels[20 * kWidth + 20] = 5;
        EXPECT_EQ(spots_of(reference, pixels, kWidth).count, away == 2 ? 0U : 1U) << away;
    }
}

TEST(Spots, what_is_darker_than_the_picture_is_none) {
    Pixels reference(kWidth * 40, 1);
    for (std::size_t i = 0; i < kWidth * 20; ++i) reference[i] = 0.001;
    Pixels pixels = reference;
    pixels[5 * kWidth + 5] = 0.4;
    EXPECT_EQ(spots_of(reference, pixels, kWidth).count, 0U);
}

/// Squared errors of 16, 16 and 4: the worst two of 2,000 pixels hold 32 of 36.
TEST(Spots, the_share_of_the_worst_thousandth) {
    const Pixels reference(kWidth * 40, 1);
    Pixels pixels = reference;
    pixels[100] = 5;
    pixels[200] = 5;
    pixels[300] = 3;
    EXPECT_NEAR(spots_of(reference, pixels, kWidth).worst_share, 32.0 / 36.0, 1e-12);
}

}  // namespace
}  // namespace sunfleck::engine
