// What --sun takes, and what it says of the rest.
#include "flags/sun_value.h"

#include "sunfleck/error.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(SunValue, is_a_pair_of_angles) {
    const SunPosition sun = read_sun("120.5,30", "--sun");
    EXPECT_EQ(sun.azimuth, 120.5);
    EXPECT_EQ(sun.elevation, 30);
}

TEST(SunValue, is_a_moment_and_a_place) {
    const SunPosition sun = read_sun("2003-10-17,12:30:30-07:00,39.742476,-105.1786", "--sun");
    EXPECT_NEAR(sun.azimuth, 194.340241, 0.01);
    EXPECT_NEAR(sun.elevation, 39.872046, 0.01);
    const SunPosition same = read_sun("2003-10-17,19:30:30Z,39.742476,-105.1786", "--sun");
    EXPECT_EQ(same.azimuth, sun.azimuth);
}

TEST(SunValue, of_another_form_is_told_with_the_right_one) {
    for (const auto& [text, why] : {std::pair("30", "is no place of the sun"),
                                    {"1,2,3", "is no place of the sun"},
                                    {"a,b", "--sun"},
                                    {"10,-3", "below the horizon"},
                                    {"2026-12-21,02:00Z,48,16", "below the horizon"},
                                    {"2026-02-29,12:00Z,48,16", "no date of the calendar"},
                                    {"2026-2-9,12:00Z,48,16", "no date of the calendar"},
                                    {"2026-02-09,12:00,48,16", "offset from UTC"},
                                    {"2026-02-09,12:60Z,48,16", "offset from UTC"},
                                    {"2026-02-09,12:00+1,48,16", "offset from UTC"},
                                    {"2026-02-09,12:00Z,91,16", "--sun"}}) {
        try {
            read_sun(text, "--sun");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
        }
    }
}

TEST(SunValue, knows_leap_years) {
    EXPECT_NO_THROW(read_sun("2028-02-29,12:00Z,48,16", "--sun"));
    EXPECT_THROW(read_sun("2100-02-29,12:00Z,48,16", "--sun"), Error);
}

}  // namespace
}  // namespace sunfleck::engine
