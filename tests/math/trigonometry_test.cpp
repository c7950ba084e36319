// Sine and cosine of a turn, against long double.
#include "math/trigonometry.h"

#include "core/random.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr long double kTwoPi = 6.283185307179586476925286766559L;

double worst_error(double turn) {
    const SinCos got = sin_cos_2pi(turn);
    const long double angle = kTwoPi * static_cast<long double>(turn);
    const long double sine = std::abs(std::sin(angle) - static_cast<long double>(got.sin));
    const long double cosine = std::abs(std::cos(angle) - static_cast<long double>(got.cos));
    return static_cast<double>(std::max(sine, cosine));
}

TEST(Trigonometry, is_within_3e_16_over_three_turns) {
    RandomStream random(1, Purpose::test, 0, 0);
    for (int i = 0; i < 200000; ++i) ASSERT_LT(worst_error(3 * random.next() - 1.5), 3e-16);
}

TEST(Trigonometry, is_within_3e_16_where_quadrants_meet) {
    for (int eighth = -16; eighth <= 16; ++eighth)
        for (const double off : {-1e-3, -1e-12, -0x1p-53, 0.0, 0x1p-53, 1e-12, 1e-3})
            EXPECT_LT(worst_error(eighth / 8.0 + off), 3e-16) << eighth << " " << off;
}

TEST(Trigonometry, quarters_are_exact) {
    const std::array<double, 4> sines = {0, 1, 0, -1};
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const SinCos got = sin_cos_2pi(static_cast<double>(quarter) / 4 - 1);
        EXPECT_EQ(got.sin, sines[quarter]);
        EXPECT_EQ(got.cos, sines[(quarter + 1) % 4]);
    }
}

TEST(Trigonometry, whole_turns_change_nothing) {
    for (const double turn : {0.125, 0.3125, 0.84375}) {
        EXPECT_EQ(sin_cos_2pi(turn).sin, sin_cos_2pi(turn + 1048576).sin);
        EXPECT_EQ(sin_cos_2pi(turn).cos, sin_cos_2pi(turn - 1048576).cos);
    }
}

}  // namespace
}  // namespace sunfleck::engine
