// Whole glTF files: extensions, and all public samples that are here.
#include "import/gltf/reader.h"

#include "gltf_files.h"
#include "scene/scene.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

using testing_support::square_json;
using testing_support::warns;

class GltfReader : public testing_support::GltfFiles {};

TEST_F(GltfReader, required_extensions_that_are_not_read_are_refused) {
    EXPECT_EQ(fault_of(R"("extensionsRequired":["KHR_draco_mesh_compression"])"),
              "scene.gltf: extensionsRequired[0]: requires the extension "
              "KHR_draco_mesh_compression, which is not read; export the scene without it");
    EXPECT_EQ(fault_of(R"("extensionsRequired":["KHR_mesh_quantization"])"), "");
}

TEST_F(GltfReader, used_extensions_that_are_not_read_are_named) {
    const SceneDescription scene =
        read(R"("extensionsUsed":["KHR_materials_sheen","KHR_materials_ior","KHR_xmp"])");
    EXPECT_TRUE(warns(scene, "the extension KHR_materials_sheen is not read"));
    EXPECT_EQ(scene.warnings.entries().size(), 3U) << "and of camera and light";
}

/// Animations are left out, and said to be.
TEST_F(GltfReader, animations_stand_as_at_rest) {
    EXPECT_TRUE(warns(read(R"("animations":[{}])"), "animations are left out"));
}

/// A mirrored node keeps its outside out.
TEST_F(GltfReader, mirrored_nodes_keep_their_facing) {
    for (const char* scale : {"[1,1,1]", "[-1,1,1]", "[1,-1,1]"}) {
        const Scene scene(read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":)" +
                               std::string(scale) + "}]," + square_json()));
        const Vec3d from(scale[1] == '-' ? -0.4 : 0.4, scale[3] == '-' ? -0.3 : 0.3, 5);
        const auto hit =
            scene.geometry().intersect(Ray{Vec3(from - scene.origin()), Vec3(0, 0, -1), 100.0F});
        ASSERT_TRUE(hit) << scale;
        EXPECT_GT(hit->normal.z, 0.9F) << scale;
    }
}

std::vector<fs::path> samples() {
    const fs::path folder = fs::path(SUNFLECK_SOURCE_DIR) / "../shared/data/gltf";
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// All but the one that requires Draco are read, and have something to be seen.
TEST_F(GltfReader, public_samples_are_read) {
    if (samples().empty()) GTEST_SKIP() << "shared/data/gltf is not here";
    for (const fs::path& file : samples()) {
        if (file.string().find("draco") != std::string::npos) {
            EXPECT_THROW(read_gltf(file.string()), Error) << file;
            continue;
        }
        const SceneDescription scene = read_gltf(file.string());
        EXPECT_GT(scene.shapes.size() + scene.instances.size(), 0U) << file;
        const Scene built(scene);
        EXPECT_FALSE(built.is_dark()) << file;
    }
}

}  // namespace
}  // namespace sunfleck::engine
