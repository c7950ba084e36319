// Barycentric weights; areas; the shape of the error bound.
#include "geometry/triangle.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

const Triangle kRight{{Vec3d(0, 0, 0), Vec3d(2, 0, 0), Vec3d(0, 1, 0)}};

TEST(Triangle, weights_give_the_point_where_the_line_passes) {
    test::Dice dice(6);
    for (int i = 0; i < 10000; ++i) {
        const Triangle t{{dice.in_box(3), dice.in_box(3), dice.in_box(3)}};
        const double u = dice.number(0, 0.5);
        const double v = dice.number(0, 0.5);
        const Vec3d target = t.point({1 - u - v, u, v});
        const Vec3d direction = dice.direction();
        const Vec3d w = barycentrics(t, target - direction * 5, direction, {0, 0});
        EXPECT_LT(test::distance(t.point(w), target), 1e-9);
    }
}

TEST(Triangle, a_line_just_outside_gives_its_own_point_and_one_far_off_a_point_of_the_triangle) {
    const Vec3d near = barycentrics(kRight, {1, -1e-7, 5}, {0, 0, -1}, {0, 0});
    EXPECT_NEAR(near.z, -1e-7, 1e-15);
    EXPECT_NEAR(near.y, 0.5, 1e-15);
    const Vec3d far = barycentrics(kRight, {1, -0.1, 5}, {0, 0, -1}, {0, 0});
    EXPECT_NEAR((far - Vec3d(0.5, 0.5, 0)).length(), 0, 1e-15);
    const Vec3d beyond = barycentrics(kRight, {1.25, 1, 5}, {0, 0, -1}, {0, 0});
    EXPECT_NEAR((kRight.point(beyond) - Vec3d(1, 0.5, 0)).length(), 0, 1e-15);
    EXPECT_EQ(beyond.x, 0);
    const Vec3d corner = barycentrics(kRight, {9, -1, 5}, {0, 0, -1}, {0, 0});
    EXPECT_EQ(corner, Vec3d(0, 1, 0));
}

TEST(Triangle, a_line_in_the_plane_falls_back) {
    const Vec3d w = barycentrics(kRight, {-1, 0.25, 0}, {1, 0, 0}, {0.25, 0.5});
    EXPECT_EQ(w, Vec3d(0.25, 0.25, 0.5));
}

TEST(Triangle, area_and_its_absence) {
    EXPECT_DOUBLE_EQ(kRight.area(), 1);
    EXPECT_TRUE(kRight.has_area());
    const Triangle line{
        {Vec3d(0.1F, 0.2F, 0.3F), Vec3d(0.2F, 0.4F, 0.6F), Vec3d(0.4F, 0.8F, 1.2F)}};
    EXPECT_FALSE(line.has_area());
    EXPECT_FALSE((Triangle{{Vec3d(1), Vec3d(1), Vec3d(2)}}.has_area()));
}

TEST(Triangle, floats_lose_nothing_on_planes_along_the_axes) {
    EXPECT_EQ(plane_uncertainty(kRight, kRight.area_vector(), {0.5, 0.25, 0}), 0);
    EXPECT_EQ(rounding_uncertainty({0, 0, 1}, {1000, 2000, 0}), 0);
}

TEST(Triangle, the_bound_grows_with_size_and_with_flatness) {
    const auto bound = [](double size, double height) {
        const Triangle t{{Vec3d(0, 0, 0), Vec3d(size, size, size),
                          Vec3d(size, size, size) / 2 + Vec3d(height, -height, 0)}};
        return plane_uncertainty(t, t.area_vector(), t.point(Vec3d(1.0 / 3)));
    };
    EXPECT_NEAR(bound(10, 5) / bound(1, 0.5), 10, 1e-6);
    EXPECT_GT(bound(1, 1e-4), 100 * bound(1, 0.5));
    EXPECT_LT(bound(1, 0.5), 2e-6);
}

}  // namespace
}  // namespace sunfleck::engine
