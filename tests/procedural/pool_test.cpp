// The pool: a closed body of water that ends within the walls, with the normals of its waves.

#include "procedural/pool.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Pool, the_water_is_closed_and_faces_out) {
    const Mesh water = pool_water();
    EXPECT_TRUE(open_edges(water).empty());
    EXPECT_NEAR(volume(water), 5.2 * 9.2 * 1.9, 0.3);
}

/// Waves add up to heights below five centimetres, and never break.
TEST(Pool, waves_are_low_and_their_normals_agree_with_the_facets) {
    const Mesh water = pool_water();
    for (const auto& t : water.triangles) {
        const Vec3d facet = area_vector(water, t).normalized();
        for (const std::uint32_t vertex : t) {
            const auto& n = water.normals.at(vertex);
            ASSERT_GT(facet.dot(Vec3d(n[0], n[1], n[2])), 0.99);
            const double height = corner(water, vertex).z;
            if (n[2] > 0.5F) {
                ASSERT_NEAR(height, 1.8, 0.055);
            }
        }
    }
}

}  // namespace
}  // namespace sunfleck::engine
