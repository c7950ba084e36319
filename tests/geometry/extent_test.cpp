// What is too large or too far for ray tracing.
#include "geometry/extent.h"

#include "geometry/support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Extent, counts_what_geometry_leaves_out) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1e19F, 0, 1}, {1e16F, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 4}, {0, 2, 3}, {0, 0, 0}, {0, 1, 77}};
    EXPECT_EQ(count_out_of_range({mesh, {}}), 2U);
    EXPECT_EQ(count_out_of_range({mesh, test::scaling(1e-3, 1e-3, 1e-3)}), 0U);
    EXPECT_EQ(count_out_of_range({mesh, test::scaling(1e18, 1e18, 1e18)}), 5U);
    EXPECT_EQ(count_out_of_range({Sphere{1e19, -1e19, 1e19}, {}}), 1U);
    EXPECT_EQ(count_out_of_range({Sphere{}, test::scaling(1e19, 1, 1)}), 1U);
    EXPECT_EQ(count_out_of_range({Sphere{}, {}}), 0U);
    EXPECT_EQ(count_out_of_range({Disk{1e19}, {}}), 1U);
}

}  // namespace
}  // namespace sunfleck::engine
