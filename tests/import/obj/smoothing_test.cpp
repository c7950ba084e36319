// Normals of smoothing groups.
#include "import/obj/smoothing.h"

#include "import/obj/reader.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

/// Two squares that meet at a right angle along the y axis, the second of two triangles.
const std::string kCorner = "v 0 0 0\nv 0 1 0\nv -1 1 0\nv -1 0 0\nv 0 0 1\nv 0 1 1\n";

std::vector<ObjTriangle> normals_of(const std::string& faces, std::vector<Vec3>& normals) {
    ObjMesh mesh = parse_obj(kCorner + faces, "a.obj");
    normals = mesh.normals;
    return mesh.normal_corners;
}

/// The diagonal of a square counts as much at an end as no diagonal: angles add up.
TEST(Smoothing, weighs_faces_by_their_angles) {
    std::vector<Vec3> normals;
    const auto corners = normals_of("s 1\nf 1 2 3 4\nf 1 6 2\nf 1 5 6\n", normals);
    ASSERT_EQ(corners.size(), 4U);
    const float half = std::sqrt(0.5F);
    // The first lies in z = 0 with normal z, the second in x = 0 with normal x or -x.
    for (const std::size_t corner : {std::size_t{0}, std::size_t{1}}) {
        const Vec3& n = normals[corners[0].at(corner)];
        EXPECT_NEAR(std::abs(n.x), half, 1e-6F);
        EXPECT_NEAR(std::abs(n.z), half, 1e-6F);
        EXPECT_NEAR(n.y, 0, 1e-6F);
    }
    EXPECT_EQ(normals[corners[1][2]], Vec3(0, 0, 1));
    EXPECT_EQ(corners[0][0], corners[3][0]) << "a vertex has one normal in its group";
}

TEST(Smoothing, keeps_the_edge_between_groups_sharp) {
    std::vector<Vec3> normals;
    const auto corners = normals_of("s 1\nf 1 2 3 4\ns 2\nf 1 6 2\n", normals);
    ASSERT_EQ(corners.size(), 3U);
    for (const std::uint32_t n : corners[0]) EXPECT_EQ(normals[n], Vec3(0, 0, 1));
    for (const std::uint32_t n : corners[2]) EXPECT_EQ(normals[n].z, 0);
}

TEST(Smoothing, leaves_triangles_alone_that_are_off_or_have_normals) {
    std::vector<Vec3> normals;
    EXPECT_TRUE(normals_of("f 1 2 3 4\n", normals).empty());
    EXPECT_TRUE(normals_of("s off\nf 1 2 3 4\ns 0\nf 1 6 2\n", normals).empty());
    const auto corners = normals_of("vn 1 2 3\ns 1\nf 1//1 2//1 3//1\ns off\nf 1 6 2\n", normals);
    const std::vector<ObjTriangle> expected = {{0, 0, 0}, {kNoIndex, kNoIndex, kNoIndex}};
    EXPECT_EQ(corners, expected);
    EXPECT_EQ(normals.size(), 1U);
}

/// Two faces back to back cancel at their vertices: these stay flat.
TEST(Smoothing, that_cancels_is_left_out) {
    std::vector<Vec3> normals;
    const auto corners = normals_of("s 1\nf 1 2 3\nf 3 2 1\n", normals);
    EXPECT_EQ(corners[0][0], kNoIndex);
}

}  // namespace
}  // namespace sunfleck::engine
