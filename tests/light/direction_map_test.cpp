// Maps of directions: back and forth, and solid angles.
#include "light/direction_map.h"

#include "math/warp.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(DirectionMap, goes_back_and_forth) {
    for (const DirectionMap& map : {DirectionMap(), DirectionMap::latitude_longitude(7)})
        for (double x = 0.03; x < 1; x += 0.09)
            for (double y = 0.02; y < 1; y += 0.07) {
                const Vec3d w = map.direction({x, y});
                EXPECT_NEAR(w.length(), 1, 1e-12);
                const Vec2d back = map.place(w);
                EXPECT_NEAR(back.x, x, 1e-6);
                EXPECT_NEAR(back.y, y, 1e-6);
            }
}

TEST(DirectionMap, of_latitude_and_longitude_has_the_pole_above_and_x_at_the_left_edge) {
    const DirectionMap map = DirectionMap::latitude_longitude(2);
    EXPECT_TRUE(map.direction({0.3, 0}).equalWithAbsError({0, 0, 1}, 1e-12));
    EXPECT_TRUE(map.direction({0, 0.5}).equalWithAbsError({1, 0, 0}, 1e-12));
    EXPECT_TRUE(map.direction({0.25, 0.5}).equalWithAbsError({0, 1, 0}, 1e-12));
    EXPECT_TRUE(map.direction({0.6, 1}).equalWithAbsError({0, 0, -1}, 1e-12));
    EXPECT_EQ(map.place({0, 0, 1}).y, 0);
    EXPECT_EQ(map.place({0, 0, -1}).y, 1);
    EXPECT_NEAR(map.place(Vec3d(1, -1e-9, 0)).x, 1, 1e-6);
}

/// Rows at the poles are narrow: a ring of 30 degrees around one is (1 - cos 30) / 2 of the sphere.
TEST(DirectionMap, gives_rows_their_solid_angles) {
    const DirectionMap map = DirectionMap::latitude_longitude(6);
    EXPECT_NEAR(map.share(0) / 6, (1 - std::sqrt(0.75)) / 2, 1e-12);
    EXPECT_NEAR(map.share(2) / 6, 0.25, 1e-12);
    double sum = 0;
    for (int row = 0; row < 6; ++row) sum += map.share(row) / 6;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(DirectionMap().share(3), 1);
}

TEST(DirectionMap, is_told_by_the_shape_of_the_image) {
    EXPECT_TRUE(map_of_size({8, 8})->has_equal_areas());
    EXPECT_FALSE(map_of_size({16, 8})->has_equal_areas());
    EXPECT_FALSE(map_of_size({16, 9}));
    EXPECT_TRUE(map_of_size({1, 1})->has_equal_areas());
}

}  // namespace
}  // namespace sunfleck::engine
