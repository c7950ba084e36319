// Shapes of meshes: solid glass with its medium, instances, sharing.
#include "import/gltf/shapes.h"

#include "gltf_files.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

using testing_support::buffer_json;
using testing_support::bytes_of;
using testing_support::expect_same;
using testing_support::square_json;

class GltfShape : public testing_support::GltfFiles {
protected:
    /// A tetrahedron of side 1 along the axes, outside out, of glass.
    static std::string glass(const std::string& extensions) {
        const std::string bytes = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
                                  bytes_of<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
        return R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" + buffer_json(bytes) +
               R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":0,"byteOffset":48,"componentType":5123,"type":"SCALAR","count":12}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1],"roughnessFactor":0,"metallicFactor":0},
"extensions":{"KHR_materials_transmission":{"transmissionFactor":1})" +
               extensions + "}}]";
    }
    static constexpr double kChord = 4 * (1.0 / 6) / (1.5 + 0.8660254);
};

/// Whether or not its exporter has given it a volume.
TEST_F(GltfShape, glass_of_a_closed_surface_is_solid) {
    const SceneDescription scene = read(glass(""));
    ASSERT_EQ(scene.shapes.size(), 1U);
    const ShapeDescription& shape = scene.shapes[0];
    EXPECT_TRUE(std::holds_alternative<DielectricMaterial>(scene.materials[shape.material]));
    EXPECT_EQ(shape.media, (MediumSides{1, 0}));
    // A straight way of mean length has half of the red.
    const auto red = static_cast<float>(std::log(2) / kChord);
    expect_same(scene.media.all.at(1).absorption, Spectrum::rgb_unbounded({red, 0, 0}));
}

TEST_F(GltfShape, glass_is_what_it_is_told_to_be) {
    const std::string open = [&] {
        std::string closed = glass("");
        const std::string count = R"("count":12)";
        return closed.replace(closed.find(count), count.size(), R"("count":9)");
    }();
    const auto is_solid = [&](const std::string& members, GlassRule rule) {
        ImportSettings settings;
        settings.glass = rule;
        const SceneDescription scene = read_gltf(gltf(members), settings);
        EXPECT_EQ(testing_support::warns(scene, "(--glass"), rule == GlassRule::automatic);
        return std::holds_alternative<DielectricMaterial>(
            scene.materials[scene.shapes.at(0).material]);
    };
    EXPECT_TRUE(is_solid(glass(""), GlassRule::automatic));
    EXPECT_FALSE(is_solid(glass(""), GlassRule::thin));
    EXPECT_FALSE(is_solid(open, GlassRule::automatic));
    EXPECT_TRUE(is_solid(open, GlassRule::solid));
    std::string cut = glass("");
    cut.insert(cut.find(R"("pbrMetallic)"), R"("alphaMode":"MASK",)");
    EXPECT_FALSE(is_solid(cut, GlassRule::automatic)) << "alpha makes holes";
}

/// A quarter turn of the direction in which u grows is that in which v grows.
TEST_F(GltfShape, anisotropy_turns_the_tangents) {
    const std::string bytes =
        bytes_of<float>({0, 0, 0, 2, 0, 0, 0, 0, 3, /* v down */ 0, 1, 1, 1, 0, 0});
    const SceneDescription scene =
        read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" + buffer_json(bytes) +
             R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":0,"byteOffset":36,"componentType":5126,"type":"VEC2","count":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"materials":[{"extensions":{"KHR_materials_anisotropy":{"anisotropyStrength":1,
"anisotropyRotation":1.5707963267948966}}}])");
    const auto& mesh = std::get<TriangleMesh>(scene.shapes.at(0).placed.shape);
    ASSERT_EQ(mesh.tangents.size(), 3U);
    EXPECT_LT((mesh.tangents[0] - Vec3(0, 0, 1)).length(), 1e-6F) << mesh.tangents[0];
}

TEST_F(GltfShape, volumes_absorb_by_beers_law) {
    const SceneDescription scene =
        read(glass(R"(,"KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,
"attenuationColor":[1,0.25,1]})"));
    const auto red = static_cast<float>(std::log(2) / kChord);
    const auto green = static_cast<float>(std::log(4) / 2);
    expect_same(scene.media.all.at(1).absorption, Spectrum::rgb_unbounded({red, green, 0}));
}

/// Half of the green is thrown back by a deep medium: 0.93652 of each event is scattered, where
/// van de Hulst's s is 0.29712 and g is 0.3.
TEST_F(GltfShape, volumes_scatter_what_attenuation_does_not_absorb) {
    const SceneDescription scene =
        read(glass(R"(,"KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,
"attenuationColor":[1,0.25,1]},
"KHR_materials_volume_scatter":{"multiscatterColor":[0,0.5,0],"scatterAnisotropy":0.3})"));
    const Medium& medium = scene.media.all.at(1);
    const auto red = static_cast<float>(std::log(2) / kChord);
    const double green = std::log(4) / 2;
    const auto scattered = static_cast<float>(green * 0.93652);
    expect_same(medium.scattering, Spectrum::rgb_unbounded({0, scattered, 0}));
    expect_same(medium.absorption,
                Spectrum::rgb_unbounded({red, static_cast<float>(green) - scattered, 0}));
    EXPECT_FLOAT_EQ(medium.g, 0.3F);
    EXPECT_EQ(scene.shapes.at(0).media, (MediumSides{1, 0}));
    EXPECT_FALSE(testing_support::warns(scene, "volume_scatter"));
}

/// A material that lets no light in, and a pane, which has no inside.
TEST_F(GltfShape, volumes_that_scatter_in_vain_are_named) {
    const std::string volume =
        R"("KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,
"attenuationColor":[0.5,0.5,0.5]},"KHR_materials_volume_scatter":{"multiscatterColor":[1,1,1]})";
    const SceneDescription opaque =
        read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{"extensions":{)" +
             volume + "}}]," + square_json(R"(,"material":0)"));
    EXPECT_TRUE(testing_support::warns(opaque, "where KHR_materials_transmission lets no light"));
    ImportSettings settings;
    settings.glass = GlassRule::thin;
    const SceneDescription pane = read_gltf(gltf(glass("," + volume)), settings);
    EXPECT_TRUE(testing_support::warns(pane, "thin glass has no inside"));
}

TEST_F(GltfShape, a_mesh_of_several_nodes_is_one_object) {
    const SceneDescription scene = read(
        R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[5,0,0]}],)" +
        square_json());
    EXPECT_TRUE(scene.shapes.empty());
    ASSERT_EQ(scene.objects.size(), 1U);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.instances[1].to_world[3][0], 5);
}

TEST_F(GltfShape, copies_without_an_extent_are_left_out) {
    const SceneDescription scene =
        read(R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"scale":[0,1,1]}],)" +
             square_json());
    EXPECT_EQ(scene.instances.size(), 1U);
    EXPECT_TRUE(testing_support::warns(scene, "nodes[1]: warning: is flat or too small"));
}

/// Lights cannot be parts of objects.
TEST_F(GltfShape, a_mesh_that_shines_stands_for_itself) {
    const SceneDescription scene =
        read(R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[5,0,0]}],
"materials":[{"emissiveFactor":[1,1,1]}],)" +
             square_json(R"(,"material":0)"));
    EXPECT_TRUE(scene.instances.empty());
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(scene.shapes[1].placed.to_world[3][0], 5);
}

}  // namespace
}  // namespace sunfleck::engine
