// The exposure that a picture asks for.
#include "image/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

Picture even_picture(const std::vector<float>& values) {
    Picture picture;
    picture.width = static_cast<int>(values.size());
    picture.height = 1;
    for (const char* name : {"R", "G", "B"}) picture.add(name).values = values;
    return picture;
}

TEST(Exposure, shows_an_even_picture_as_middle_grey) {
    EXPECT_NEAR(automatic_stops(even_picture({0.18F})), 0, 1e-9);
    EXPECT_NEAR(automatic_stops(even_picture({0.18F * 1024, 0.18F * 1024})), -10, 1e-9);
}

TEST(Exposure, takes_the_middle_of_bright_and_dark_and_no_black) {
    EXPECT_NEAR(automatic_stops(even_picture({0.18F / 16, 0.18F * 4})), 1, 1e-9);
    EXPECT_NEAR(automatic_stops(even_picture({0, 0, 0, 0.36F})), -1, 1e-9);
    EXPECT_NEAR(automatic_stops(even_picture({0.36F, INFINITY})), -1, 1e-9);
    EXPECT_EQ(automatic_stops(even_picture({0, 0})), 0);
}

/// A lit thing before a background that is black but for a little noise.
TEST(Exposure, is_not_of_what_is_nearly_black) {
    std::vector<float> light(100, 1e-5F);
    light.push_back(0.36F);
    EXPECT_NEAR(automatic_stops(even_picture(light)), -1, 1e-9);
}

TEST(Exposure, that_is_given_is_kept) {
    EXPECT_EQ(stops_of({.stops = 3.5}, even_picture({7})), 3.5);
    EXPECT_EQ(stops_of({.is_automatic = true, .stops = 3.5}, even_picture({0.18F})), 0);
}

}  // namespace
}  // namespace sunfleck::engine
