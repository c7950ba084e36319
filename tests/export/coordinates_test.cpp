// Coordinates that textures cannot say are given to meshes.
#include "export/coordinates.h"

#include "export/round_trip.h"

namespace sunfleck::engine {
namespace {

constexpr const char* kMesh = R"(
Material "diffuse"
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 0 ] "point2 uv" [ 0 0  1 0  0 1  1 1 ]
    "integer indices" [ 0 1 2  2 1 3 ]
)";

/// A mesh that is coloured by a picture of 2 x 2 texels.
SceneDescription coloured_mesh(const Mapping& mapping) {
    SceneDescription scene = read_world(kMesh);
    SpectrumImageKind kind;
    kind.image = std::make_shared<const Image>(
        Vec2i(2, 2), 3, std::vector<float>{0.9F, 0, 0, 0, 0.8F, 0, 0, 0, 0.7F, 0.6F, 0.6F, 0.1F});
    kind.nearest = true;
    kind.mapping = mapping;
    scene.materials.at(scene.shapes.at(0).material) =
        DiffuseMaterial{SpectrumTexture(SpectrumKind{std::move(kind)})};
    return scene;
}

SampledSpectrum colour_at(const SceneDescription& scene, std::uint32_t triangle,
                          const Vec2& weights) {
    const ShapeDescription& shape = scene.shapes.at(0);
    const auto& mesh = std::get<TriangleMesh>(shape.placed.shape);
    const auto& corners = mesh.triangles.at(triangle);
    TexturePoint point;
    point.primitive = triangle;
    point.weights = weights;
    point.uv = mesh.uvs.at(corners[0]) * (1 - weights.x - weights.y) +
               mesh.uvs.at(corners[1]) * weights.x + mesh.uvs.at(corners[2]) * weights.y;
    const auto& material = std::get<DiffuseMaterial>(scene.materials.at(shape.material));
    return material.reflectance.at(point, some_wavelengths());
}

void expect_same_colours(const SceneDescription& scene) {
    EXPECT_TRUE(pbrt_scene(scene, "cup.pbrt").warnings.entries().empty());
    const SceneDescription read = again(scene);
    for (const std::uint32_t triangle : {0U, 1U})
        for (const Vec2& weights : {Vec2(0.1F, 0.1F), Vec2(0.7F, 0.2F), Vec2(0.15F, 0.65F)})
            expect_near(colour_at(scene, triangle, weights), colour_at(read, triangle, weights),
                        1e-5F, "colour");
}

TEST(ExportedCoordinates, are_turned_in_the_mesh) {
    expect_same_colours(
        coloured_mesh(TurnedUvMapping{{0.8F, 0.6F}, {-0.6F, 0.8F}, {0.13F, 0.31F}}));
}

TEST(ExportedCoordinates, of_a_second_set_take_the_place_of_the_first) {
    VertexMapping mapping;
    const SceneDescription scene = read_world(kMesh);
    mapping.coordinates.triangles = std::make_shared<const VertexValues<Vec2>::Triangles>(
        std::get<TriangleMesh>(scene.shapes.at(0).placed.shape).triangles);
    mapping.coordinates.values = std::make_shared<const std::vector<Vec2>>(
        std::vector<Vec2>{{0.2F, 0.9F}, {0.1F, 0.1F}, {0.8F, 0.7F}, {0.9F, 0.2F}});
    expect_same_colours(coloured_mesh(mapping));
}

TEST(ExportedCoordinates, stay_where_something_else_needs_them) {
    SceneDescription scene =
        coloured_mesh(TurnedUvMapping{{0.8F, 0.6F}, {-0.6F, 0.8F}, {0.13F, 0.31F}});
    const auto image =
        std::make_shared<const Image>(Vec2i(1, 1), 3, std::vector<float>{0.5F, 0.6F, 1});
    scene.bump_maps.at(scene.shapes.at(0).material) = NormalMap{image};
    EXPECT_FALSE(common_mapping(scene.shapes.at(0), scene.materials, scene.bump_maps));
    EXPECT_EQ(pbrt_scene(scene, "cup.pbrt").warnings.entries().size(), 1U);
}

}  // namespace
}  // namespace sunfleck::engine
