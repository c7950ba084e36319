// How wide discs are for direct photons and caustics, and for indirect photons.
#include "camera_paths/settings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(FirstRadius, is_one_pixel_in_small_pictures_and_two_in_large_ones) {
    EXPECT_EQ(first_radius({}, {1, 1}), 1);
    EXPECT_EQ(first_radius({}, {168, 168}), 1);
    EXPECT_DOUBLE_EQ(first_radius({}, {256, 256}), 2 * std::exp2(-0.625));
    EXPECT_DOUBLE_EQ(first_radius({}, {1024, 64}), 2 * std::exp2(-0.625));
    EXPECT_EQ(first_radius({}, {512, 512}), 2);
    EXPECT_EQ(first_radius({}, {1920, 1080}), 2);
}

TEST(FirstRadius, is_what_the_user_says) {
    CameraPathSettings settings;
    settings.radius_pixels = 7;
    EXPECT_EQ(first_radius(settings, {16, 12}), 7);
    EXPECT_EQ(first_radius(settings, {1920, 1080}), 7);
}

double indirect_pixels(const Vec2i& resolution) {
    return first_radius({}, resolution) * indirect_radius_scale({}, resolution);
}

TEST(IndirectRadiusScale, grows_with_the_picture) {
    EXPECT_DOUBLE_EQ(indirect_pixels({256, 256}), 4);
    EXPECT_DOUBLE_EQ(indirect_pixels({1024, 64}), 4);
    EXPECT_DOUBLE_EQ(indirect_pixels({512, 512}), 4 * std::exp2(0.625));
    EXPECT_NEAR(indirect_pixels({1920, 1080}), 4 * std::pow(5.625, 0.625), 1e-12);
}

TEST(IndirectRadiusScale, is_not_less_than_two_pixels) {
    EXPECT_GT(indirect_pixels({86, 86}), 2);
    EXPECT_EQ(indirect_pixels({84, 84}), 2);
    EXPECT_EQ(indirect_pixels({1, 1}), 2);
}

TEST(IndirectRadiusScale, is_what_the_user_says) {
    CameraPathSettings settings;
    settings.indirect_radius = 7;
    EXPECT_EQ(indirect_radius_scale(settings, {16, 12}), 7);
    EXPECT_EQ(indirect_radius_scale(settings, {1920, 1080}), 7);
}

TEST(IndirectRadiusScale, of_radii_that_the_user_says_is_that_of_two_pixels) {
    for (const int side : {16, 84, 256, 512, 1000}) {
        CameraPathSettings pixels;
        pixels.radius_pixels = 7;
        CameraPathSettings length;
        length.radius = 0.3;
        EXPECT_EQ(indirect_radius_scale(pixels, {side, side}),
                  indirect_radius_scale(length, {side, side}));
        EXPECT_DOUBLE_EQ(2 * indirect_radius_scale(pixels, {side, side}),
                         indirect_pixels({side, side}));
    }
}

}  // namespace
}  // namespace sunfleck::engine
