// Caster samples: photons of their emission meet a caster first, whatever shape it has and however
// small it is.
#include "photon/caster_samples.h"

#include "photon/tracer.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kFloor = 0;
constexpr std::uint32_t kGlass = 1;
constexpr std::uint32_t kMixed = 2;

/// A floor 2 km wide, below the sun, and a lamp.
SceneDescription wide_scene() {
    SceneDescription scene;
    MixMaterial mix;
    mix.components = {kFloor, kGlass};
    scene.materials = {DiffuseMaterial{Spectrum::constant(0.5F)}, DielectricMaterial{}, mix};
    TriangleMesh floor;
    floor.positions = {{-1000, -1000, 0}, {1000, -1000, 0}, {1000, 1000, 0}, {-1000, 1000, 0}};
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.shapes = {{{floor, Matrix(), false}, kFloor, {}, {}}};
    scene.lights = {DistantLight{Spectrum::constant(1), {0.6, 0, -0.8}}};
    return scene;
}

Matrix moved(double x) {
    Matrix matrix;
    matrix.translate(Vec3d(x, 3, 1));
    return matrix;
}

/// A triangle with an invalid corner among others, which is not in the geometry.
Shape triangles() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5F}, {1, 1, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 1, 77}};
    return mesh;
}

Shape patches() {
    BilinearMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5F}, {1, 1, 1}};
    mesh.patches = {{0, 1, 2, 3}};
    return mesh;
}

/// Returns the share of samples whose photon meets `shape` first.
double share_on(const Scene& scene, std::uint32_t shape, std::size_t& count) {
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport{DirectLight::sampled, 64};
    const PhotonTracer tracer(pass, transport);
    const std::vector<WeightedEmission> samples =
        caster_samples(pass, scene.light_choice(), {1, 0}, {0, 2000});
    std::size_t on = 0;
    for (const WeightedEmission& sample : samples) {
        EXPECT_GT(sample.weight, 0);
        const auto read = [&](std::uint32_t index) {
            return to_fraction(index < kGuidedDimensions ? sample.point.at(index) : 0.5);
        };
        PhotonState state;
        Hit hit;
        if (tracer.start(read, state) && tracer.complete(tracer.send(state), state, hit))
            on += hit.shape == shape ? 1 : 0;
    }
    count = samples.size();
    return static_cast<double>(on) / static_cast<double>(samples.size());
}

TEST(CasterSamples, reach_casters_of_every_shape) {
    for (const Shape& shape : {triangles(), patches(), Shape(Sphere{0.5}), Shape(Disk{0, 0.7}),
                               Shape(Cylinder{0.3, -0.5, 0.5})}) {
        SceneDescription description = wide_scene();
        description.shapes.push_back({{shape, moved(40), false}, kGlass, {}, {}});
        std::size_t count = 0;
        EXPECT_GT(share_on(Scene(description), 1, count), 0.97) << shape.index();
        EXPECT_GT(count, 1300U) << shape.index();
    }
}

TEST(CasterSamples, reach_a_mix_with_glass_and_no_diffuse_surface) {
    SceneDescription description = wide_scene();
    const Scene bare(description);
    EXPECT_TRUE(
        caster_samples(PassScene(bare, {1, 0}), bare.light_choice(), {1, 0}, {0, 100}).empty());
    description.shapes.push_back({{Sphere{0.5}, moved(40), false}, kMixed, {}, {}});
    std::size_t count = 0;
    EXPECT_GT(share_on(Scene(description), 1, count), 0.97);
}

/// A stone beside a shop window: half of the samples are spread over shapes, not area.
TEST(CasterSamples, reach_a_small_caster_beside_a_large_one) {
    SceneDescription description = wide_scene();
    description.shapes.push_back({{Sphere{0.01}, moved(40), false}, kGlass, {}, {}});
    description.shapes.push_back({{Sphere{20.0}, moved(-400), false}, kGlass, {}, {}});
    std::size_t count = 0;
    EXPECT_NEAR(share_on(Scene(description), 1, count), 0.25, 0.05);
}

}  // namespace
}  // namespace sunfleck::engine
