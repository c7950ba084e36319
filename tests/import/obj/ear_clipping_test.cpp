// Polygons of all kinds, by the area that their triangles cover.
#include "import/obj/ear_clipping.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

using Corners = std::vector<Vec3d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Returns the sum of the triangles' areas, each counted by its size, and their sum as vectors.
double area_of(const Corners& corners, const Triangles& triangles, Vec3d* sum = nullptr) {
    double area = 0;
    for (const auto& t : triangles) {
        const Vec3d twice = (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
        area += twice.length() / 2;
        if (sum != nullptr) *sum += twice * 0.5;
    }
    return area;
}

TEST(EarClipping, makes_a_fan_of_a_convex_polygon) {
    const Corners hexagon = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
    const Triangles fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    EXPECT_EQ(triangulated(hexagon).triangles, fan);
    const Corners quad = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}};
    const Triangles halves = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(triangulated(quad).triangles, halves);
}

/// From any first corner, seen along any axis, either way round.
TEST(EarClipping, covers_a_concave_polygon_once) {
    const Corners l_shape = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    for (std::size_t first = 0; first < l_shape.size(); ++first)
        for (int axis = 0; axis < 3; ++axis)
            for (const bool is_reversed : {false, true}) {
                Corners corners;
                for (std::size_t i = 0; i < l_shape.size(); ++i) {
                    const Vec3d& p = l_shape[(first + i) % l_shape.size()];
                    corners.emplace_back(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
                }
                if (is_reversed) std::reverse(corners.begin(), corners.end());
                const Triangulation cut = triangulated(corners);
                Vec3d sum(0);
                EXPECT_NEAR(area_of(corners, cut.triangles, &sum), 5, 1e-12);
                EXPECT_NEAR(sum.length(), 5, 1e-12);
                EXPECT_TRUE(cut.is_simple);
                EXPECT_EQ(cut.triangles.size(), 4U);
            }
}

/// A square ring, its outline led to the hole and back, as CAD programs write faces with holes.
TEST(EarClipping, leaves_a_hole_that_the_outline_reaches_by_a_bridge) {
    const Corners ring = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                          {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    const Triangulation cut = triangulated(ring);
    EXPECT_NEAR(area_of(ring, cut.triangles), 12, 1e-12);
}

TEST(EarClipping, keeps_corners_on_straight_edges) {
    const Corners square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
    const Triangulation cut = triangulated(square);
    EXPECT_NEAR(area_of(square, cut.triangles), 4, 1e-12);
    EXPECT_TRUE(cut.is_simple);
}

TEST(EarClipping, tells_of_an_outline_that_crosses_itself) {
    const Corners bow = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}};
    const Triangulation cut = triangulated(bow);
    EXPECT_EQ(cut.triangles.size(), 2U);
    EXPECT_FALSE(cut.is_simple);
}

TEST(EarClipping, knows_convex_quads) {
    EXPECT_TRUE(is_convex_quad({Vec3d(0, 0, 0), {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0}}));
    EXPECT_FALSE(is_convex_quad({Vec3d(0, 0, 0), {2, 0, 0}, {0.3, 0.3, 0}, {0, 2, 0}}));
    EXPECT_FALSE(is_convex_quad({Vec3d(0, 0, 0), {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
}

}  // namespace
}  // namespace sunfleck::engine
