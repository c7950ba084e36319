// Azimuths against the library's arc tangent; sine and cosine against the library's.
#include "geometry/sweep.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Sweep, sine_and_cosine_are_good_to_the_last_bits) {
    for (int i = -1232; i <= 1232; ++i) {  // a turn either way
        const double angle = i * 0.0051;
        EXPECT_NEAR(sin_cos(angle).sin, std::sin(angle), 0x1p-50) << angle;
        EXPECT_NEAR(sin_cos(angle).cos, std::cos(angle), 0x1p-50) << angle;
    }
}

TEST(Sweep, a_point_is_inside_when_its_azimuth_is) {
    test::Dice dice(2);
    for (int i = 0; i < 20000; ++i) {
        const double end = dice.number(0, kFullCircle);
        const double x = dice.number(-1, 1);
        const double y = dice.number(-1, 1);
        const double angle =
            std::atan2(y, x) < 0 ? std::atan2(y, x) + kFullCircle : std::atan2(y, x);
        if (std::abs(angle - end) < 1e-9) continue;
        EXPECT_EQ(Sweep(end).contains(x, y), angle <= end) << end << " " << x << " " << y;
    }
}

TEST(Sweep, the_whole_turn_holds_everything_and_no_turn_nothing) {
    for (const double y : {-1e-300, 0.0, 1e-300}) EXPECT_TRUE(Sweep(kFullCircle).contains(1, y));
    EXPECT_TRUE(Sweep(100).contains(-1, -1));
    EXPECT_FALSE(Sweep(0).contains(1, 1e-9));
    EXPECT_FALSE(Sweep(-1).contains(0, 1));
    EXPECT_TRUE(Sweep(kPiDouble).contains(0, 1));
    EXPECT_FALSE(Sweep(kPiDouble).contains(0, -1));
}

TEST(Sweep, azimuths_run_from_zero_to_a_whole_turn) {
    EXPECT_FLOAT_EQ(azimuth(1, 0), 0);
    EXPECT_FLOAT_EQ(azimuth(0, 2), kPi / 2);
    EXPECT_FLOAT_EQ(azimuth(0, -2), 1.5F * kPi);
}

}  // namespace
}  // namespace sunfleck::engine
