// What of a PLY file's body becomes a mesh, and what is left out.
#include "import/ply/body.h"

#include "import/ply/reader.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// A file of vertices x y z and of faces. @param rows  its body.
std::string of_rows(const std::string& rows, const std::string& vertices = "3",
                    const std::string& faces = "1") {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty double y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n" + rows;
}

void expect_ply_refusal(const std::string& bytes, const std::string& begin) {
    std::string message;
    try {
        parse_ply(bytes, "m.ply");
    } catch (const Error& error) {
        message = error.what();
    }
    EXPECT_EQ(message.substr(0, begin.size()), begin) << message;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(PlyBody, faces_of_fewer_than_three_corners_are_left_out) {
    const std::string v = "0 0 0\n1 0 0\n0 1 0\n";
    const PlyMesh mesh = parse_ply(of_rows(v + "0\n3 0 1 2\n1 2\n2 0 1\n3 2 1 0\n", "3", "5"), "m");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {2, 1, 0}}));
    ASSERT_EQ(mesh.remarks.size(), 1U);
    EXPECT_EQ(mesh.remarks[0], "faces of fewer than three corners are left out (3)");
}

TEST(PlyBody, broken_vertices_that_no_face_uses_are_left_out) {
    for (const char* broken : {"nan nan nan", "-1.#IND 1.#INF 0", "0 1.#QNAN00 0", "inf 0 0",
                               "-nan(ind) 0 0", "1e999 0 0"}) {
        const PlyMesh mesh = parse_ply(
            of_rows(std::string(broken) + "\n0 0 0\n1 0 0\n" + broken + "\n0 1 0\n3 1 2 4\n", "5"),
            "m");
        EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}})) << broken;
        ASSERT_EQ(mesh.positions.size(), 3U) << broken;
        EXPECT_EQ(mesh.positions[2], Vec3d(0, 1, 0)) << broken;
        ASSERT_EQ(mesh.remarks.size(), 1U) << broken;
        EXPECT_NE(mesh.remarks[0].find("left out (2)"), std::string::npos) << mesh.remarks[0];
    }
    expect_ply_refusal(of_rows("0 0 0\n1 0 1.#INF\n0 1 0\n3 0 1 2\n"),
                       "m.ply: vertex 1: a number that is");
    expect_ply_refusal(of_rows("0 0 0\n1 0 1.#BAD\n0 1 0\n3 0 1 2\n"),
                       "m.ply: vertex 1: \"1.#BAD\" is no");
}

/// Exporters write them where a mesh was not unfolded.
TEST(PlyBody, texture_coordinates_that_are_not_finite_are_zero) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float s\nproperty float t\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n";
    const PlyMesh mesh =
        parse_ply(head + "0 0 0 nan 1\n1 0 0 1 -nan(ind)\n0 1 0 .5 .25\n3 0 1 2\n", "m");
    ASSERT_EQ(mesh.uvs.size(), 3U);
    EXPECT_EQ(mesh.uvs[0], Vec2(0));
    EXPECT_EQ(mesh.uvs[1], Vec2(0));
    EXPECT_EQ(mesh.uvs[2], Vec2(.5F, .25F));
    ASSERT_EQ(mesh.remarks.size(), 1U);
    EXPECT_NE(mesh.remarks[0].find("texture coordinates"), std::string::npos);
    EXPECT_NE(mesh.remarks[0].find("(2)"), std::string::npos);
}

TEST(PlyBody, texture_coordinates_of_faces_are_told) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
        "property list uchar float texcoord\nend_header\n";
    const PlyMesh mesh = parse_ply(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 1 1\n", "m");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
    ASSERT_EQ(mesh.remarks.size(), 1U);
    EXPECT_NE(mesh.remarks[0].find("give each vertex its own"), std::string::npos);
}

TEST(PlyBody, decimals_with_a_comma_are_told) {
    expect_ply_refusal(of_rows("0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                       "m.ply: vertex 0: \"0,5\" is no number, which has a point");
}

TEST(PlyBody, strips_of_triangles_are_named) {
    expect_ply_refusal(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 -1\n",
        "m.ply:7:1: its faces are strips of triangles");
}

/// A transfer as text may leave two carriage returns before each line end.
TEST(PlyBody, lines_may_end_in_any_way) {
    const std::string plain = of_rows("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (const std::string end : {"\r", "\r\n", "\r\r\n", "\n\n"}) {
        std::string text;
        for (const char c : plain) text += c == '\n' ? end : std::string(1, c);
        EXPECT_EQ(parse_ply(text, "m").triangles, (Triangles{{0, 1, 2}}));
    }
    std::string odd = of_rows("");
    odd.replace(odd.find("element"), 7, "ele\rment");
    expect_ply_refusal(odd, "m.ply:3:1: unknown statement \"ele\"");
}

TEST(PlyBody, planar_convex_polygons_are_cut_and_others_refused) {
    const std::string pentagon = "0 0 0\n2 0 0\n3 1 0\n1 2 0\n-1 1 0\n";
    const PlyMesh mesh = parse_ply(of_rows(pentagon + "5 0 1 2 3 4\n3 2 1 0\n", "5", "2"), "m");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {2, 1, 0}}));
    ASSERT_EQ(mesh.remarks.size(), 1U);
    EXPECT_EQ(mesh.remarks[0], "faces of more than four corners are cut into triangles (1)");
    const std::string bent = "0 0 0\n2 0 0\n3 1 1\n1 2 0\n-1 1 0\n";
    expect_ply_refusal(of_rows(bent + "5 0 1 2 3 4\n", "5"),
                       "m.ply: face 0: it has 5 corners that are not");
    const std::string dart = "0 0 0\n2 0 0\n1 .5 0\n1 2 0\n-1 1 0\n";
    expect_ply_refusal(of_rows(dart + "5 0 1 2 3 4\n", "5"),
                       "m.ply: face 0: it has 5 corners that are not");
    expect_ply_refusal(of_rows(pentagon + "3 0 1 2\n5 0 2 4 1 3\n", "5", "2"),
                       "m.ply: face 1: it has 5");
}

}  // namespace
}  // namespace sunfleck::engine
