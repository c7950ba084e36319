// Colours and other coordinates of vertices, as they colour what is hit.
#include "import/gltf/vertices.h"

#include "gltf_files.h"
#include "scene/scene.h"

namespace sunfleck::engine {
namespace {

using testing_support::buffer_json;
using testing_support::bytes_of;

class GltfVertexTest : public testing_support::GltfFiles {
protected:
    /// A triangle (0,0) (4,0) (0,4) with colours: floats, or bytes of `type` and `code`.
    static std::string triangle(const std::string& colours, const std::string& type, int code) {
        const bool is_normalized = code != 5126;
        return R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" +
               buffer_json(bytes_of<float>({0, 0, 0, 4, 0, 0, 0, 4, 0}) + colours) +
               R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":0,"byteOffset":36,"count":3,"componentType":)" +
               std::to_string(code) + R"(,"type":")" + type +
               (is_normalized ? R"(","normalized":true)" : R"(")") +
               R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},
"material":0}]}],"materials":[{"alphaMode":"BLEND","pbrMetallicRoughness":
{"baseColorFactor":[1,1,0.5,1]}}])";
    }
};

/// Red, green and blue at the corners, interpolated; the blue by half.
TEST_F(GltfVertexTest, colours_are_interpolated_and_times_the_base_colour) {
    SceneDescription scene =
        read(triangle(bytes_of<float>({0.8F, 0, 0, 0, 0.8F, 0, 0, 0, 0.8F}), "VEC3", 5126));
    const auto metal = std::get<ConductorMaterial>(scene.materials[scene.shapes[0].material]);
    const Wavelengths wavelengths = Wavelengths::of_pass({});
    const SampledSpectrum wanted = Spectrum::rgb_albedo({0.2F, 0.2F, 0.2F}).at(wavelengths);
    for (const bool is_smooth : {false, true}) {  // hits on flat meshes go another way
        if (is_smooth)
            std::get<TriangleMesh>(scene.shapes[0].placed.shape).normals.assign(3, Vec3(0, 0, 1));
        const Scene built(scene);
        const auto hit = built.geometry().intersect(
            Ray{Vec3(Vec3d(1, 2, 5) - built.origin()), Vec3(0, 0, -1), 100.0F});
        ASSERT_TRUE(hit);
        const SampledSpectrum found = metal.reflectance->at(TexturePoint(*hit), wavelengths);
        for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-4F);
    }
}

/// Bytes as floats; of four, the last is alpha.
TEST_F(GltfVertexTest, colours_may_be_integers_with_alpha) {
    const std::string bytes =
        bytes_of<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 0});
    const SceneDescription scene = read(triangle(bytes, "VEC4", 5121));
    Hit hit;
    hit.weights = Vec2(0, 0.5F);
    EXPECT_FLOAT_EQ(scene.shapes.at(0).placed.cover(hit), 0.5F);
}

TEST_F(GltfVertexTest, arrays_that_do_not_fit_are_refused) {
    std::string file = triangle(bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 1}), "VEC3", 5126);
    const std::string count = R"("byteOffset":36,"count":3)";
    file.replace(file.find(count), count.size(), R"("byteOffset":36,"count":2)");
    EXPECT_EQ(fault_of(file),
              "scene.gltf: meshes[0].primitives[0].attributes.COLOR_0: has 2 vertices, POSITION 3; "
              "export the file again");
}

/// Integers that the file forgets to call normalised are so: a colour is at most 1.
TEST_F(GltfVertexTest, colours_of_integers_are_normalised_whatever_the_file_says) {
    const auto cover = [&](std::string file) {
        const std::string flag = R"(,"normalized":true)";
        file.erase(file.find(flag), flag.size());
        const SceneDescription scene = read(file);
        Hit hit;
        hit.weights = Vec2(0, 0.5F);
        return scene.shapes.at(0).placed.cover(hit);
    };
    const std::string bytes =
        bytes_of<std::uint8_t>({255, 0, 0, 204, 0, 255, 0, 204, 0, 0, 255, 51});
    EXPECT_FLOAT_EQ(cover(triangle(bytes, "VEC4", 5121)), 0.5F);
    const std::string words =
        bytes_of<std::uint16_t>({65535, 0, 0, 52428, 0, 65535, 0, 52428, 0, 0, 65535, 13107});
    EXPECT_FLOAT_EQ(cover(triangle(words, "VEC4", 5123)), 0.5F);
}

}  // namespace
}  // namespace sunfleck::engine
