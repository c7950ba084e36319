// DensityGrid: closed forms.
#include "medium/density_grid.h"

#include "medium/density_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr float kRoot3 = 1.7320508F;

DensityGrid box_of_ones(int parts) {
    const auto count = static_cast<std::size_t>(parts);
    const std::vector<float> ones(count * count * count, 1);
    return density_of_parts(ones, {parts, parts, parts}, Affine());
}

/// The unit cube with one corner of density one, and seven of zero.
DensityGrid one_corner() {
    std::vector<float> values(8, 0);
    values[7] = 1;
    return density_of_points(values, {1, 1, 1}, Affine());
}

TEST(DensityGrid, of_ones_is_one_where_centres_are_all_around) {
    for (const int parts : {8, 9, 40}) {
        const DensityGrid grid = box_of_ones(parts);
        EXPECT_EQ(grid.at(Vec3(0.5F)), 1);
        const Ray way{Vec3(0.1F, 0.2F, 0.3F), Vec3(2, 3, 6) / 7, 0.7F};
        EXPECT_FLOAT_EQ(grid.amount(way), 0.7F);
        EXPECT_FLOAT_EQ(grid.distance_at(way, 0.31F), 0.31F);
    }
}

/// pbrt-v4's samples end half a part before the box: at its border half of the last one is left.
TEST(DensityGrid, of_parts_falls_to_one_half_at_the_border) {
    const DensityGrid grid = box_of_ones(4);
    EXPECT_FLOAT_EQ(grid.at({0, 0.5F, 0.5F}), 0.5F);
    EXPECT_FLOAT_EQ(grid.at({1, 1, 0.5F}), 0.25F);
    // From 1/2 to 1 within 1/8, on both sides.
    EXPECT_FLOAT_EQ(grid.amount({Vec3(-3, 0.5F, 0.5F), Vec3(1, 0, 0)}), 1 - 2 * 0.125F * 0.25F);
    EXPECT_FLOAT_EQ(grid.mean(), std::pow(1 - 2 * 0.125F * 0.25F, 3.0F));
}

/// On the diagonal the density is t^3: a cubic, so that a rule of one point fails.
TEST(DensityGrid, integrates_a_cubic_exactly) {
    const DensityGrid grid = one_corner();
    const Vec3 diagonal = Vec3(1) / kRoot3;
    EXPECT_FLOAT_EQ(grid.amount({Vec3(0), diagonal}), kRoot3 / 4);
    EXPECT_FLOAT_EQ(grid.amount({Vec3(-1), diagonal}), kRoot3 / 4);
    EXPECT_FLOAT_EQ(grid.amount({Vec3(0), diagonal, kRoot3 / 2}), kRoot3 / 64);
    EXPECT_FLOAT_EQ(grid.distance_at({Vec3(0), diagonal}, kRoot3 / 64), kRoot3 / 2);
    EXPECT_FLOAT_EQ(grid.greatest(), 1);
    EXPECT_FLOAT_EQ(grid.mean(), 0.125F);
}

TEST(DensityGrid, distances_start_where_the_density_does) {
    const DensityGrid grid = box_of_ones(8);
    const Ray way{Vec3(-3, 0.5F, 0.5F), Vec3(1, 0, 0)};
    EXPECT_FLOAT_EQ(grid.distance_at(way, 0), 3);
    EXPECT_FLOAT_EQ(grid.distance_at(way, 5), 4);
}

TEST(DensityGrid, ways_may_run_within_the_borders_of_cells) {
    const DensityGrid grid = box_of_ones(32);
    for (const float y : {1.5F / 32, 8.5F / 32, 16.5F / 32, 17.5F / 32}) {
        EXPECT_FLOAT_EQ(grid.amount({Vec3(0.125F, y, y), Vec3(1, 0, 0), 0.5F}), 0.5F);
        EXPECT_FLOAT_EQ(grid.amount({Vec3(y, 0.875F, y), Vec3(0, -1, 0), 0.5F}), 0.5F);
    }
}

/// Blocks of one value are one number: the same density by values that differ a little.
TEST(DensityGrid, blocks_of_one_value_are_as_others) {
    constexpr int kParts = 24;
    std::vector<float> ones(kParts * kParts * kParts, 1);
    const DensityGrid even = density_of_parts(ones, {kParts, kParts, kParts}, Affine());
    for (std::size_t i = 0; i < ones.size(); ++i) ones[i] += i % 2 == 0 ? 1e-6F : 0;
    const DensityGrid uneven = density_of_parts(ones, {kParts, kParts, kParts}, Affine());
    const Ray way{Vec3(-1, -0.5F, 0.3F), Vec3(2, 1.5F, 0.2F).normalized()};
    EXPECT_NEAR(even.amount(way), uneven.amount(way), 2e-6F);
    EXPECT_NEAR(even.distance_at(way, 0.4F), uneven.distance_at(way, 0.4F), 2e-6F);
}

TEST(DensityGrid, an_amount_of_a_stretched_box_is_by_the_worlds_length) {
    const std::vector<float> ones(12 * 12 * 12, 3);
    Affine stretched;
    stretched.x = {10, 0, 0};
    const DensityGrid grid = density_of_parts(ones, {12, 12, 12}, stretched);
    EXPECT_FLOAT_EQ(grid.amount({Vec3(1, 0.5F, 0.5F), Vec3(1, 0, 0), 8}), 24);
}

}  // namespace
}  // namespace sunfleck::engine
