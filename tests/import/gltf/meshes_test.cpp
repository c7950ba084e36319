// Triangles of primitives: topologies, attributes, morph targets, skins.
#include "import/gltf/meshes.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::buffer_json;
using testing_support::bytes_of;
using testing_support::square_bytes;
using testing_support::square_json;

class GltfMeshes : public testing_support::GltfFiles {
protected:
    /// Returns mesh 0 as a node shows it. @param node  in the order of the scene.
    std::optional<TriangleMesh> mesh_of(const std::string& members, std::size_t node = 0) {
        const GltfDocument document(gltf(members));
        const Accessors accessors(document);
        const GltfNodes nodes(document, accessors);
        const JsonPlace mesh = document.root().elements("meshes").front();
        const MeshPose pose = pose_of(document, nodes, accessors, nodes.in_scene().at(node), mesh);
        return triangles_of(accessors, mesh.elements("primitives").front(), pose, 0, warnings_);
    }

    static constexpr const char* kNode = R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)";
    Warnings warnings_;
};

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST_F(GltfMeshes, lists_share_vertices) {
    const auto mesh = mesh_of(kNode + square_json());
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh->triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(mesh->normals.empty()) << "flat";
}

/// Every other triangle of a strip is turned, so that all face one way; a fan turns about vertex 0.
TEST_F(GltfMeshes, strips_and_fans_face_one_way) {
    const auto of_mode = [&](const char* mode) {
        std::string members = kNode + square_json(R"(,"mode":)" + std::string(mode));
        const std::string indices = R"("indices":1,)";
        return mesh_of(members.erase(members.find(indices), indices.size()))->triangles;
    };
    EXPECT_EQ(of_mode("5"), (Triangles{{0, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(of_mode("6"), (Triangles{{1, 2, 0}, {2, 3, 0}}));
    EXPECT_EQ(of_mode("4"), (Triangles{{0, 1, 2}})) << "the fourth corner makes no triangle";
}

TEST_F(GltfMeshes, points_and_lines_are_left_out_with_a_warning) {
    EXPECT_FALSE(mesh_of(kNode + square_json(R"(,"mode":1)")));
    ASSERT_EQ(warnings_.entries().size(), 1U);
    EXPECT_NE(warnings_.entries()[0].line().find("points and lines"), std::string::npos);
}

/// The v of glTF goes down, ours up.
TEST_F(GltfMeshes, texture_coordinates_are_turned_over) {
    std::string members =
        kNode + buffer_json(square_bytes() + bytes_of<float>({0, 0.25F, 1, 0.25F, 1, 1, 0, 1}));
    members += R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":0,"byteOffset":60,"componentType":5126,"type":"VEC2","count":4}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}])";
    EXPECT_EQ(mesh_of(members)->uvs, (std::vector<Vec2>{{0, 0.75F}, {1, 0.75F}, {1, 0}, {0, 0}}));
}

TEST_F(GltfMeshes, morph_targets_move_vertices_by_their_weights) {
    const std::string bytes =
        bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, /* by */ 0, 0, 2, 0, 0, 4, 0, 0, 6});
    const std::string members =
        buffer_json(bytes) +
        R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":0,"byteOffset":36,"componentType":5126,"type":"VEC3","count":3}],
"meshes":[{"weights":[0.5],"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}]}])";
    EXPECT_EQ(mesh_of(kNode + members)->positions,
              (std::vector<Vec3>{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}}));
    EXPECT_EQ(mesh_of(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"weights":[1]}],)" + members)
                  ->positions[2],
              Vec3(0, 1, 6))
        << "a node's weights go before its mesh's";
}

/// Vertex 0 follows a joint that moves by 10 in x, vertex 1 half of it, vertex 2 one at rest.
TEST_F(GltfMeshes, skins_move_vertices_with_joints_whatever_their_node_does) {
    const std::string bytes = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                              bytes_of<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}) +
                              bytes_of<float>({1, 0, 0, 0, .5F, .5F, 0, 0, 1, 0, 0, 0});
    const auto mesh = mesh_of(
        R"("scenes":[{"nodes":[0,1,2]}],"nodes":[{"mesh":0,"skin":0,"translation":[99,0,0]},
{"translation":[10,0,0]},{}],"skins":[{"joints":[1,2]}],)" +
        buffer_json(bytes) +
        R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":0,"byteOffset":36,"componentType":5121,"type":"VEC4","count":3},
{"bufferView":0,"byteOffset":48,"componentType":5126,"type":"VEC4","count":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}}]}])");
    EXPECT_EQ(mesh->positions, (std::vector<Vec3>{{10, 0, 0}, {6, 0, 0}, {0, 1, 0}}));
}

TEST_F(GltfMeshes, arrays_that_do_not_fit_are_refused) {
    std::string members = kNode + square_json();
    const std::string count = R"("count":4)";
    members.replace(members.find(count), count.size(), R"("count":3)");
    EXPECT_EQ(fault_of(members),
              "scene.gltf: meshes[0].primitives[0].indices: names vertex 3 of 3; export the file "
              "again");
    EXPECT_NE(fault_of(kNode + square_json(R"(,"mode":7)")), "");
    EXPECT_NE(fault_of(kNode + square_json(R"(,"material":0)")), "");
}

/// The largest index of its type begins a strip or a fan anew (KHR_mesh_primitive_restart).
TEST_F(GltfMeshes, the_largest_index_begins_anew) {
    const std::string bytes =
        bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
        bytes_of<std::uint16_t>({0, 1, 2, 0xFFFF, 1, 2, 3, 0, 0xFFFF, 0xFFFF, 2, 3});
    const auto of_mode = [&](const char* mode) {
        const std::string members =
            buffer_json(bytes) +
            R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":0,"byteOffset":48,"componentType":5123,"type":"SCALAR","count":12}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":)" +
            mode + "}]}]";
        return mesh_of(kNode + members)->triangles;
    };
    EXPECT_EQ(of_mode("5"), (Triangles{{0, 1, 2}, {1, 2, 3}, {2, 0, 3}}));
    EXPECT_EQ(of_mode("6"), (Triangles{{1, 2, 0}, {2, 3, 1}, {3, 0, 1}}));
    EXPECT_THROW(of_mode("4"), Error) << "a list has no such thing";
}

/// The node's frame says which side is out, though it does not move the vertices.
TEST_F(GltfMeshes, skins_of_mirrored_nodes_keep_their_facing) {
    const std::string bytes = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                              bytes_of<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
                              bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const auto mesh = mesh_of(
        R"("scenes":[{"nodes":[2]}],"nodes":[{"mesh":0,"skin":0},{},{"children":[0,1],"scale":[-1,1,1]}],
"skins":[{"joints":[1]}],)" +
            buffer_json(bytes) +
            R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":0,"byteOffset":36,"componentType":5121,"type":"VEC4","count":3},
{"bufferView":0,"byteOffset":48,"componentType":5126,"type":"VEC4","count":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}}]}])",
        1);
    EXPECT_EQ(mesh->positions[1], Vec3(-1, 0, 0));
    EXPECT_EQ(mesh->triangles, (Triangles{{0, 2, 1}}));
}

/// A joint may be outside of the scene: it moves the mesh all the same.
TEST_F(GltfMeshes, joints_outside_of_the_scene_have_frames) {
    const std::string bytes = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                              bytes_of<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
                              bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const auto mesh = mesh_of(
        R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"skin":0},{"translation":[3,0,0]},
{"children":[1],"translation":[4,0,0]}],"skins":[{"joints":[1]}],)" +
        buffer_json(bytes) +
        R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":0,"byteOffset":36,"componentType":5121,"type":"VEC4","count":3},
{"bufferView":0,"byteOffset":48,"componentType":5126,"type":"VEC4","count":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}}]}])");
    EXPECT_EQ(mesh->positions[1], Vec3(8, 0, 0));
}

/// Where triangles have no area exporters divide by 0.
TEST_F(GltfMeshes, normals_that_are_no_numbers_are_as_if_they_were_missing) {
    const float nan = std::nanf("");
    const std::string members =
        kNode +
        buffer_json(square_bytes() + bytes_of<float>({nan, nan, nan, 0, 0, 0, 0, 0, 1, 0, 0, 1})) +
        R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":0,"byteOffset":48,"componentType":5123,"type":"SCALAR","count":6},
{"bufferView":0,"byteOffset":60,"componentType":5126,"type":"VEC3","count":4}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":2},"indices":1}]}])";
    const auto mesh = mesh_of(members);
    EXPECT_EQ(mesh->normals, (std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
}

/// All zeros: the accessors of some exporters have neither a buffer view nor sparse values.
TEST_F(GltfMeshes, morph_targets_without_a_buffer_move_nothing) {
    std::string members = kNode + square_json();
    const std::string attribute = R"("attributes":{"POSITION":0},)";
    members.insert(members.find(attribute) + attribute.size(), R"("targets":[{"POSITION":2}],)");
    const std::string end = R"("count":6})";
    members.insert(members.find(end) + end.size(),
                   R"(,{"componentType":5126,"type":"VEC3","count":4})");
    members.insert(members.find(R"("primitives")"), R"("weights":[1],)");
    EXPECT_EQ(mesh_of(members)->positions[2], Vec3(1, 1, 0));
}

}  // namespace
}  // namespace sunfleck::engine
