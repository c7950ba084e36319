// The scene as stages see it: who emits, what is no obstacle, how lights are weighed.
#include "scene/pass_scene.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// A square of side 2 at height z, facing up.
ShapeDescription square(float z, std::uint32_t material) {
    TriangleMesh mesh;
    mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {{mesh, Matrix(), false}, material, {}, {}};
}

ShapeDescription lamp(float z, std::uint32_t material, float radiance) {
    ShapeDescription shape = square(z, material);
    shape.emission = AreaEmission{Spectrum::constant(radiance), false, 0};
    return shape;
}

SceneDescription with_materials() {
    SceneDescription scene;
    scene.materials = {DiffuseMaterial{}, InterfaceMaterial{}};
    return scene;
}

Hit down_from(const Scene& scene, float z) {
    return scene.geometry().intersect({{0.2F, 0.3F, z}, {0, 0, -1}, kInfinity}).value();
}

TEST(Scene, each_triangle_of_an_emitter_is_a_light) {
    SceneDescription description = with_materials();
    description.shapes = {square(0, 0), lamp(1, 0, 2), lamp(2, 0, 6)};
    const Scene scene(std::move(description));
    ASSERT_EQ(scene.lights().size(), 4U);
    EXPECT_EQ(scene.light_of(down_from(scene, 0.5F)), kNone);
    const Hit lower = down_from(scene, 1.5F);
    const Hit upper = down_from(scene, 3);
    EXPECT_EQ(scene.light_of(lower), lower.primitive);
    EXPECT_EQ(scene.light_of(upper), 2 + upper.primitive);
    // By power: radiance 2 and 6, equal areas, two triangles each.
    EXPECT_NEAR(scene.light_choice().probability(0), 0.125, 1e-9);
    EXPECT_NEAR(scene.light_choice().probability(3), 0.375, 1e-9);
    EXPECT_TRUE(scene.has_lights_to_hit());
}

/// pbrt-v4 gives each triangle the whole power: a quad of two emits twice as much as asked. Seen
/// there as 0.05091 in a pixel where the quad's own area would give half of it.
TEST(Scene, power_of_a_mesh_is_that_of_each_triangle) {
    SceneDescription description = with_materials();
    description.shapes = {lamp(1, 0, 3)};
    description.shapes.front().emission->power = 8;
    const Scene scene(std::move(description));
    for (const Light& light : scene.lights()) {
        const double flux = power(light, scene.sphere()) * static_cast<double>(curve(light)(550));
        EXPECT_NEAR(flux, 3 * 8, 1e-4);
    }
}

TEST(Scene, interfaces_are_no_obstacle) {
    SceneDescription description = with_materials();
    description.shapes = {square(0, 0), square(1, 1), lamp(2, 1, 3)};
    const Scene scene(std::move(description));
    const Hit floor = down_from(scene, 1.5F);  // past the one that does not emit
    EXPECT_EQ(floor.position.z, 0);
    EXPECT_FALSE(scene.is_null_interface(floor));
    const Hit emitter = down_from(scene, 3);
    EXPECT_EQ(emitter.position.z, 2);
    EXPECT_TRUE(scene.is_null_interface(emitter));
    EXPECT_TRUE(scene.is_free({{0.2F, 0.3F, 3}, {0, 0, -1}, 2.9F}));
    EXPECT_FALSE(scene.is_free({{0.2F, 0.3F, 3}, {0, 0, -1}, 3.1F}));
}

TEST(Scene, lights_that_no_ray_meets) {
    SceneDescription description = with_materials();
    description.shapes = {square(0, 0)};
    description.lights = {PointLight{Spectrum::constant(1), {0, 0, 1}}};
    EXPECT_FALSE(Scene(description).has_lights_to_hit());
    description.lights.emplace_back(InfiniteLight{Spectrum::constant(1)});
    const Scene scene(description);
    EXPECT_TRUE(scene.has_lights_to_hit());
    EXPECT_EQ(scene.infinite_lights(), std::vector<std::uint32_t>{1});
}

TEST(Scene, darkness_is_told_once) {
    SceneDescription description = with_materials();
    description.shapes = {square(0, 0)};
    const Scene scene(std::move(description));
    EXPECT_TRUE(scene.light_choice().empty());
    EXPECT_EQ(scene.warnings().entries().size(), 1U);
}

TEST(Scene, an_empty_scene_can_be_built) {
    const Scene scene{SceneDescription{}};
    EXPECT_FALSE(scene.geometry().intersect({{0, 0, 0}, {0, 0, 1}, kInfinity}));
    EXPECT_EQ(scene.sphere().center, Vec3d(0));
    EXPECT_GT(scene.sphere().radius, 0);
}

TEST(PassScene, evaluates_every_material_and_light) {
    SceneDescription description = with_materials();
    description.shapes = {lamp(1, 0, 2)};
    const Scene scene(std::move(description));
    const PassScene pass(scene, {3, 7});
    ASSERT_EQ(pass.bsdfs.size(), 2U);
    EXPECT_TRUE(pass.bsdfs[0].has_value());
    EXPECT_FALSE(pass.bsdfs[1].has_value());
    ASSERT_EQ(pass.emission.size(), 2U);
    EXPECT_EQ(pass.emission[0], SampledSpectrum(2));
    EXPECT_NE(pass.wavelengths.nm, PassScene(scene, {3, 8}).wavelengths.nm);
}

/// What geometry leaves out shines neither, so that light samples and hits agree.
TEST(Scene, tells_where_a_shape_is_too_large_for_ray_tracing) {
    SceneDescription description = with_materials();
    description.shapes = {square(0, 0), lamp(1, 0, 2), lamp(2, 0, 6)};
    description.shapes[2].placed.to_world.setScale(Vec3d(1e20));
    description.shapes[2].where = {"scene.pbrt", 7, 3};
    const Scene scene(std::move(description));
    ASSERT_EQ(scene.warnings().entries().size(), 1U);
    const std::string line = scene.warnings().entries()[0].line();
    EXPECT_NE(line.find("scene.pbrt:7:3"), std::string::npos) << line;
    EXPECT_NE(line.find("2 surfaces"), std::string::npos) << line;
    EXPECT_NEAR(scene.light_choice().probability(0), 0.5, 1e-9);
    EXPECT_NEAR(scene.light_choice().probability(1), 0.5, 1e-9);
    EXPECT_EQ(scene.light_of(down_from(scene, 1.5F)), down_from(scene, 1.5F).primitive);
}

TEST(Scene, is_dark_where_no_light_can_be_chosen) {
    const auto is_dark = [](float radiance, double scale) {
        SceneDescription description = with_materials();
        description.shapes = {square(0, 0), lamp(1, 0, radiance)};
        description.shapes[1].placed.to_world.setScale(Vec3d(scale));
        const Scene scene(std::move(description));
        EXPECT_EQ(scene.is_dark(), scene.light_choice().empty());
        return scene.is_dark();
    };
    EXPECT_FALSE(is_dark(1, 1));
    EXPECT_TRUE(is_dark(0, 1));
    EXPECT_TRUE(is_dark(1, 1e20));
    EXPECT_TRUE(is_dark(kInfinity, 1));
}

}  // namespace
}  // namespace sunfleck::engine
