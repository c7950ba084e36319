// What camera paths bring is kept apart when asked for; totals and counts are as without.
#include "aovs/pass_image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

double by_photons(const PassImage& image, std::size_t channel) {
    return image.by_photons(0, channel).to_double();
}

TEST(PassImage, photons_bring_what_camera_paths_do_not) {
    PassImage image(1, {}, photon_cells_of(1, 1));
    image.add_camera_light(0, Vec3(1, 2, 3), Aov::direct);
    image.add_light(0, Vec3(10, 20, -30), Aov::caustic);
    image.add_alone(0, Vec3(100, 0, 0), Aov::indirect);
    EXPECT_EQ(image.value(Aov::total, 0, 0).to_double(), 111);
    EXPECT_EQ(by_photons(image, 0), 110);
    EXPECT_EQ(by_photons(image, 1), 20);
    EXPECT_EQ(by_photons(image, 2), -30);
    EXPECT_EQ(image.photon_cells(), 1U);
    EXPECT_EQ(PassImage(1, {}).photon_cells(), 0U);
}

/// Of three columns and three rows: a cell of four pixels, two of two, one of one.
TEST(PassImage, photons_light_is_summed_by_cells_of_pixels) {
    PassImage image(9, {}, photon_cells_of(3, 3));
    for (std::size_t i = 0; i < 9; ++i) {
        image.add_light(i, Vec3(static_cast<float>(i)), Aov::caustic);
        image.add_camera_light(i, Vec3(100), Aov::direct);
    }
    ASSERT_EQ(image.photon_cells(), 4U);
    const std::array<double, 4> sums = {0 + 1 + 3 + 4, 2 + 5, 6 + 7, 8};
    for (std::size_t cell = 0; cell < 4; ++cell)
        EXPECT_EQ(image.by_photons(cell, 1).to_double(), sums.at(cell)) << cell;
}

TEST(PassImage, light_that_cannot_be_added_is_counted_once) {
    PassImage image(1, {}, photon_cells_of(1, 1));
    image.add_camera_light(0, Vec3(NAN, 1, 1), Aov::direct);
    image.add_camera_light(0, Vec3(-0x1p60F, 1, 1), Aov::direct);
    EXPECT_EQ(image.dropped(), 1U);
    EXPECT_EQ(image.saturated(), 1U);
    EXPECT_EQ(image.value(Aov::total, 0, 0).to_double(), -kLargestTerm);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(by_photons(image, c), 0);
}

TEST(PassImage, layers_of_lights_count_nothing_twice) {
    PassImage image(1, {}, photon_cells_of(1, 1), 2);
    image.add_to_light_group(0, Vec3(1, 2, 3), 0);
    image.add_to_light_group(0, Vec3(10, 0, 0), 0);
    image.add_to_light_group(0, Vec3(5, 5, 5), kNoLightGroup);
    image.add_to_light_group(0, Vec3(NAN, 1, 1), 1);
    image.add_to_light_group(0, Vec3(-0x1p60F, 1, 0), 1);
    EXPECT_EQ(image.light_groups(), 2U);
    EXPECT_EQ(image.light_value(0, 0, 0).to_double(), 11);
    EXPECT_EQ(image.light_value(0, 0, 2).to_double(), 3);
    EXPECT_EQ(image.light_value(1, 0, 0).to_double(), -kLargestTerm);
    EXPECT_EQ(image.light_value(1, 0, 1).to_double(), 1);
    EXPECT_EQ(image.dropped(), 0U);
    EXPECT_EQ(image.saturated(), 0U);
    EXPECT_EQ(image.value(Aov::total, 0, 0).to_double(), 0);
}

}  // namespace
}  // namespace sunfleck::engine
