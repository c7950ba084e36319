// The brilliant: closed, convex, its facets flat, of the proportions asked for; and as it lies.

#include "procedural/brilliant.h"

#include "mesh_checks.h"
#include "procedural/diamond.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

TEST(Brilliant, is_closed_and_faces_out) {
    const Mesh stone = brilliant({});
    EXPECT_TRUE(open_edges(stone).empty());
    EXPECT_EQ(stone.triangles.size(), 6 + 8 + 2 * 8 + 16 + 2 * 16 + 16 + 2 * 8);
    // Of round cones and cylinders: the pavilion, the girdle and the crown, a cone without its top.
    const double crown = 0.6873 * (1 - 0.55 * 0.55 * 0.55) / 3;
    EXPECT_NEAR(volume(stone) / kPiDouble, 0.8617 / 3 + 0.04 + crown, 0.06);
}

/// No corner lies outside of the plane of any triangle: convex, so that each crown and pavilion
/// facet of two triangles is flat.
TEST(Brilliant, is_convex_with_flat_facets) {
    const Mesh stone = brilliant({});
    std::size_t coplanar = 0;
    for (const auto& t : stone.triangles) {
        const Vec3d normal = area_vector(stone, t).normalized();
        std::size_t in_plane = 0;
        for (std::uint32_t i = 0; i < stone.points.size(); ++i) {
            const double height = normal.dot(corner(stone, i) - corner(stone, t[0]));
            ASSERT_LT(height, 1e-6);
            in_plane += height > -1e-6 ? 1 : 0;
        }
        coplanar += in_plane > 3 ? 1 : 0;
    }
    EXPECT_EQ(coplanar, 6 + 2 * 8 + 2 * 16 + 2 * 8);
}

TEST(Brilliant, lies_on_a_facet_just_above_the_table) {
    const Mesh stone = lying_brilliant();
    EXPECT_TRUE(open_edges(stone).empty());
    EXPECT_NEAR(volume(stone), 3.25 * 3.25 * 3.25 * volume(brilliant({})), 1e-4);
    const auto on_table = std::count_if(stone.points.begin(), stone.points.end(),
                                        [](const auto& p) { return std::abs(p[2] - 0.01) < 1e-5; });
    EXPECT_EQ(on_table, 4);  // the corners of one main facet
    EXPECT_TRUE(std::all_of(stone.points.begin(), stone.points.end(),
                            [](const auto& p) { return p[2] > 0.00999; }));
}

}  // namespace
}  // namespace sunfleck::engine
