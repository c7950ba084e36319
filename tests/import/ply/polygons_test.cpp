// Which polygons a fan of triangles covers.
#include "import/ply/polygons.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

using Corners = std::vector<Vec3d>;

/// Corners on a circle. @param step  1, or more for stars.
Corners on_circle(int count, int step, const Vec3d& centre = Vec3d(0), double height = 0) {
    Corners corners;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * kPiDouble * i * step / count;
        corners.push_back(centre +
                          Vec3d(std::cos(angle), std::sin(angle), i % 2 == 0 ? height : -height));
    }
    return corners;
}

TEST(PlyPolygons, regular_ones_are_planar_and_convex) {
    for (const int count : {5, 6, 8, 100, 10000})
        EXPECT_TRUE(is_planar_and_convex(on_circle(count, 1))) << count;
    Corners turned = on_circle(7, 1);
    for (Vec3d& c : turned) c = {c.x, 0.6 * c.y, 0.8 * c.y};
    EXPECT_TRUE(is_planar_and_convex(turned));
    std::reverse(turned.begin(), turned.end());
    EXPECT_TRUE(is_planar_and_convex(turned));
}

TEST(PlyPolygons, stars_darts_and_bent_ones_are_not) {
    EXPECT_FALSE(is_planar_and_convex(on_circle(5, 2)));
    EXPECT_FALSE(is_planar_and_convex(on_circle(7, 3)));
    EXPECT_FALSE(is_planar_and_convex(on_circle(6, 1, Vec3d(0), 0.01)));
    for (std::size_t first = 0; first < 5; ++first) {  // wherever the fan begins
        Corners dart = {{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}, {1, 2, 0}, {-1, 1, 0}};
        std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(first), dart.end());
        EXPECT_FALSE(is_planar_and_convex(dart)) << first;
    }
    // A figure of eight, whose area is zero.
    EXPECT_FALSE(
        is_planar_and_convex(Corners{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.5, 0}}));
}

TEST(PlyPolygons, corners_may_repeat_or_stand_on_an_edge) {
    const Corners square = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    EXPECT_TRUE(is_planar_and_convex(square));
    EXPECT_TRUE(is_planar_and_convex(Corners(6, Vec3d(1, 2, 3))));
    EXPECT_TRUE(
        is_planar_and_convex(Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}));
}

TEST(PlyPolygons, six_digits_far_from_the_origin_are_enough) {
    Corners corners = on_circle(8, 1, Vec3d(5000, 4000, 3000));
    for (Vec3d& c : corners)
        for (int i = 0; i < 3; ++i) c[i] = std::round(c[i] * 100) / 100;
    EXPECT_TRUE(is_planar_and_convex(corners));
}

}  // namespace
}  // namespace sunfleck::engine
