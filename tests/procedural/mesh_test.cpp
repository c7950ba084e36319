// Meshes as files: what is read back is what was written; boxes are closed.

#include "procedural/mesh.h"

#include "mesh_checks.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Mesh example() {
    Mesh mesh;
    mesh.points = {{0.1F, -2.5F, 1e-7F}, {3, 0, 0}, {1.0F / 3, 4, 70000.125F}, {-1, -1, -1}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
    return mesh;
}

TEST(Mesh, ply_keeps_every_bit) {
    const Mesh read = ply_mesh(ply_bytes(example()));
    EXPECT_EQ(read.points, example().points);
    EXPECT_EQ(read.triangles, example().triangles);
}

TEST(Mesh, ply_says_what_pbrt_expects) {
    const std::string bytes = ply_bytes(example());
    EXPECT_TRUE(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
    for (const char* line : {"\nelement vertex 4\nproperty float x\nproperty float y\n",
                             "\nelement face 2\nproperty list uchar int vertex_indices\n"})
        EXPECT_NE(bytes.find(line), std::string::npos) << line;
    // The first number, 0.1F = 0x3dcccccd, lowest byte first.
    EXPECT_EQ(bytes.substr(bytes.find("end_header\n") + 11, 4), "\xcd\xcc\xcc\x3d");
}

TEST(Mesh, text_reads_back_as_the_same_floats) {
    const Mesh read = scene_meshes({{"a.pbrt", shape_text(example())}}).at(0);
    EXPECT_EQ(read.points, example().points);
    EXPECT_EQ(read.triangles, example().triangles);
}

TEST(Mesh, normals_are_written_where_there_are_some) {
    Mesh mesh = example();
    EXPECT_EQ(shape_text(mesh).find("normal"), std::string::npos);
    mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0.6F, 0.8F, 0}};
    EXPECT_EQ(ply_mesh(ply_bytes(mesh)).normals, mesh.normals);
    EXPECT_EQ(ply_mesh(ply_bytes(mesh)).points, mesh.points);
    const std::string text = shape_text(mesh);
    EXPECT_NE(text.find("\"normal N\" [\n        0 0 1\n"), std::string::npos) << text;
}

TEST(Mesh, a_mesh_is_appended_with_its_own_points) {
    Mesh both = example();
    both.append(example());
    ASSERT_EQ(both.points.size(), 8);
    EXPECT_EQ(both.triangles[3], (std::array<std::uint32_t, 3>{7, 6, 5}));
}

TEST(Mesh, a_box_is_closed_and_faces_out) {
    const Mesh box = box_mesh({-1, 2, 3}, {1, 5, 4});
    EXPECT_EQ(box.triangles.size(), 12);
    EXPECT_TRUE(open_edges(box).empty());
    EXPECT_DOUBLE_EQ(volume(box), 6);
}

}  // namespace
}  // namespace sunfleck::engine
