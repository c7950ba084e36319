// The sun's place against published ones, within a hundredth of a degree.
#include "sky/solar_position.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// The example of Reda and Andreas, Solar Position Algorithm (NREL, 2003), without refraction.
TEST(SolarPosition, is_that_of_the_solar_position_algorithm) {
    const CivilTime time{.year = 2003,
                         .month = 10,
                         .day = 17,
                         .hours = 12 + 30.0 / 60 + 30.0 / 3600,
                         .utc_offset = -7};
    const SunPosition sun = solar_position(time, {.latitude = 39.742476, .longitude = -105.1786});
    EXPECT_NEAR(sun.azimuth, 194.340241, 0.01);
    EXPECT_NEAR(sun.elevation, 39.872046, 0.01);
}

/// Meeus, Astronomical Algorithms, example 25.a: seen from the pole the sun's elevation is its
/// declination.
TEST(SolarPosition, has_the_declination_of_the_almanac) {
    const CivilTime midnight{.year = 1992, .month = 10, .day = 13, .hours = 0};
    EXPECT_NEAR(solar_position(midnight, {.latitude = 90}).elevation, -7.78507, 0.003);
    const CivilTime solstice{.year = 2000, .month = 6, .day = 21, .hours = 1.8};
    EXPECT_NEAR(solar_position(solstice, {.latitude = 90}).elevation, 23.438, 0.003);
}

TEST(SolarPosition, goes_from_east_over_south_to_west) {
    const Place greenwich{.latitude = 51.4779, .longitude = 0};
    CivilTime time{.year = 2024, .month = 3, .day = 20, .hours = 6.2};
    EXPECT_NEAR(solar_position(time, greenwich).azimuth, 91, 2);
    time.hours = 12 + 7.5 / 60;  // the sun is late in March
    EXPECT_NEAR(solar_position(time, greenwich).azimuth, 180, 0.1);
    EXPECT_NEAR(solar_position(time, greenwich).elevation, 38.6, 0.1);
    time.hours = 18;
    EXPECT_NEAR(solar_position(time, greenwich).azimuth, 269, 2);
}

TEST(SolarPosition, knows_the_offset_of_clocks_and_the_day_before) {
    const Place place{.latitude = -33.9, .longitude = 151.2};
    const CivilTime local{.year = 2026, .month = 1, .day = 1, .hours = 8, .utc_offset = 11};
    const CivilTime utc{.year = 2025, .month = 12, .day = 31, .hours = 21};
    EXPECT_NEAR(solar_position(local, place).azimuth, solar_position(utc, place).azimuth, 1e-5);
    EXPECT_NEAR(solar_position(local, place).elevation, solar_position(utc, place).elevation, 1e-5);
}

}  // namespace
}  // namespace sunfleck::engine
