// Meshes that Draco has packed: the square of gltf_files.h, packed by its library.
#include "import/gltf/draco.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

constexpr const char* kSquare =
    "RFJBQ08CAgEAAAACBAEAAQIAAgMBAQAJAwAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAIA/"
    "AAAAAAAAAAAAAIA/"
    "AAAAAA==";

class GltfDraco : public testing_support::GltfFiles {
protected:
    void SetUp() override {
        GltfFiles::SetUp();
        if (!has_draco()) GTEST_SKIP() << "built without Draco";
    }

    /// @param id  of the packed attribute. @param size  of the packed bytes.
    static std::string square(int id, int size, int vertices) {
        return R"("extensionsRequired":["KHR_draco_mesh_compression"],"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],"buffers":[{"byteLength":76,"uri":"data:application/octet-stream;base64,)" +
               std::string(kSquare) + R"("}],"bufferViews":[{"buffer":0,"byteLength":)" +
               std::to_string(size) +
               R"(}],"accessors":[{"componentType":5126,"type":"VEC3","count":)" +
               std::to_string(vertices) +
               R"(},{"componentType":5123,"type":"SCALAR","count":6}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"extensions":
{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":)" +
               std::to_string(id) + "}}}}]}]";
    }
};

TEST_F(GltfDraco, vertices_and_triangles_are_unpacked) {
    const SceneDescription scene = read(square(0, 76, 4));
    const auto& mesh = std::get<TriangleMesh>(scene.shapes.at(0).placed.shape);
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(GltfDraco, damaged_data_and_what_does_not_fit_are_refused) {
    EXPECT_EQ(fault_of(square(0, 60, 4)),
              "scene.gltf: meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: is "
              "damaged: Draco cannot unpack it; export the file again, or without Draco");
    EXPECT_NE(fault_of(square(1, 76, 4)), "");
    EXPECT_NE(fault_of(square(0, 76, 5)), "");
}

}  // namespace
}  // namespace sunfleck::engine
