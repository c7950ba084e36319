// Extruded shapes: closed, oriented, of the volume and the number of triangles that they should be.

#include "procedural/extrusion.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(Extrusion, a_board_with_two_openings_is_closed) {
    const Mesh board =
        extrude(rectangle(0, 0, 10, 4), {rectangle(1, 1, 3, 3), arched(5, 1, 7, 2, 12)}, 2, 2.5);
    EXPECT_TRUE(open_edges(board).empty());
    EXPECT_EQ(board.triangles.size(), 4 * (4 + 4 + 15) + 4 * 2 - 4);
    const double half_circle =
        0.5 * 24 * 0.5 * std::sin(kPiDouble / 12);  // a polygon of 24, halved
    EXPECT_NEAR(volume(board), 0.5 * (40 - 4 - 2 - half_circle), 1e-5);
}

TEST(Extrusion, a_shape_need_not_be_convex) {
    const Mesh angle =
        extrude({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, {}, -1, 1);
    EXPECT_TRUE(open_edges(angle).empty());
    EXPECT_NEAR(volume(angle), 10, 1e-6);
}

TEST(Extrusion, an_ellipse_begins_on_the_x_axis) {
    const Polygon polygon = ellipse(3, 2, 8);
    ASSERT_EQ(polygon.size(), 8);
    EXPECT_EQ(polygon[0], Vec3d(3, 0, 0));
    EXPECT_EQ(polygon[2], Vec3d(0, 2, 0));
    EXPECT_NEAR(volume(extrude(polygon, {}, 0, 1)), 3 * 2 * 4 * std::sqrt(0.5), 1e-6);
}

}  // namespace
}  // namespace sunfleck::engine
