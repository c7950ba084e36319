// Buffer views that meshoptimizer has packed: the square of gltf_files.h, packed by its library.
#include "import/gltf/meshopt.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

constexpr const char* kVertices =
    "oAAAATMAAAD//wEzAAAAfn0AAAEMAAAA/wEMAAAAfgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA==";
constexpr const char* kTriangles = "4fAAAHaHVmd4qYZliWiYAWkAAA==";

class GltfMeshopt : public testing_support::GltfFiles {
protected:
    void SetUp() override {
        GltfFiles::SetUp();
        if (!has_meshopt()) GTEST_SKIP() << "built without meshoptimizer";
    }

    static std::string buffer(const char* base64, std::size_t size) {
        std::string text = R"({"byteLength":)";
        text += std::to_string(size);
        text += R"(,"uri":"data:application/octet-stream;base64,)";
        return text += std::string(base64) + R"("})";
    }
    static std::string view(int buffer, int size, int count, int stride, const std::string& mode) {
        std::string text = R"({"buffer":2,"byteLength":)";
        text += std::to_string(count * stride);
        text += R"(,"extensions":{"EXT_meshopt_compression":{"buffer":)";
        text += std::to_string(buffer);
        text += R"(,"byteLength":)";
        text += std::to_string(size);
        text += R"(,"byteStride":)";
        text += std::to_string(stride);
        text += R"(,"count":)";
        text += std::to_string(count);
        return text += R"(,"mode":")" + mode + R"("}}})";
    }
    /// The square, whose own buffer is but named, as the extension allows.
    static std::string square(const std::string& of_vertices, const std::string& of_triangles) {
        return R"("extensionsRequired":["EXT_meshopt_compression"],"buffers":[)" +
               buffer(kVertices, 67) + "," + buffer(kTriangles, 19) +
               R"(,{"byteLength":72,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}],
"bufferViews":[)" +
               of_vertices + "," + of_triangles +
               R"(],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":1,"componentType":5125,"type":"SCALAR","count":6}],"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
    }
};

TEST_F(GltfMeshopt, vertices_and_triangles_are_unpacked) {
    const SceneDescription scene =
        read(square(view(0, 67, 4, 12, "ATTRIBUTES"), view(1, 19, 6, 4, "TRIANGLES")));
    const auto& mesh = std::get<TriangleMesh>(scene.shapes.at(0).placed.shape);
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(GltfMeshopt, damaged_data_are_refused) {
    const std::string triangles = view(1, 19, 6, 4, "TRIANGLES");
    EXPECT_EQ(fault_of(square(view(0, 50, 4, 12, "ATTRIBUTES"), triangles)),
              "scene.gltf: bufferViews[0].extensions.EXT_meshopt_compression: is damaged: "
              "meshoptimizer cannot unpack it; export the file again, or without "
              "EXT_meshopt_compression");
    for (const std::string& vertices :
         {view(0, 67, 4, 10, "ATTRIBUTES"), view(0, 67, 100000000, 12, "ATTRIBUTES"),
          view(0, 67, 4, 12, "COLOURS"), view(0, 67, 4, 0, "ATTRIBUTES")})
        EXPECT_NE(fault_of(square(vertices, triangles)), "");
}

}  // namespace
}  // namespace sunfleck::engine
