// The energy ledger: what lights emit is absorbed, escapes or is cut at the greatest depth, and
// every surface sees the flux that it should.
//
// Grey scenes: Russian roulette keeps the flux of a path constant, so paths count as energy.
#include "photon/tracer.h"
#include "random_numbers/emission_points.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kPaths = 200'000;

PlacedShape box_of(float half, bool inwards) {
    TriangleMesh mesh;
    for (const float z : {-half, half})
        for (const auto& [x, y] : {std::pair(-half, -half), std::pair(half, -half),
                                   std::pair(half, half), std::pair(-half, half)})
            mesh.positions.emplace_back(x, y, z);
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                      {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    return {mesh, Matrix(), inwards};
}

ShapeDescription shape(PlacedShape placed, std::uint32_t material) {
    return {std::move(placed), material, {}, {}};
}

DiffuseMaterial grey(float albedo) {
    return {Spectrum::constant(albedo)};
}

struct Ledger {
    double emitted = 0;   // flux of wavelength 0, of all paths
    double arrived = 0;   // at surfaces that gather
    double absorbed = 0;  // by path ends, in units of flux
    double escaped = 0;
    double too_long = 0;
    double squares = 0;  // of what each path brought to surfaces
};

/// Traces all paths of a pass and books the flux of each.
Ledger ledger_of(const SceneDescription& description, int max_depth) {
    const Scene scene(description);
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport{DirectLight::photons, max_depth};
    const PhotonTracer tracer(pass, transport);
    const EmissionPoints points(PassId{1, 0});
    const double one_path = power(scene.lights()[0], scene.sphere()) *
                            static_cast<double>(pass.emission[0][0]) / kPaths;
    Ledger ledger;
    for (std::uint32_t i = 0; i < kPaths; ++i) {
        double brought = 0;
        const auto visit = [&](const Photon& photon) {
            brought += static_cast<double>(photon.flux[0]) / kPaths;
            return true;
        };
        std::uint64_t rays = 0;
        const PathEnd end = tracer.trace(points.path(i), visit, rays);
        ledger.emitted += one_path;
        ledger.arrived += brought;
        ledger.squares += brought * brought;
        if (end == PathEnd::absorbed) ledger.absorbed += one_path;
        if (end == PathEnd::escaped) ledger.escaped += one_path;
        if (end == PathEnd::too_long) ledger.too_long += one_path;
    }
    return ledger;
}

/// 99.9% interval of the flux that arrives.
double noise(const Ledger& ledger) {
    return 3.3 * std::sqrt(ledger.squares - ledger.arrived * ledger.arrived / kPaths);
}

SceneDescription lamp_in_box(float albedo) {
    SceneDescription scene;
    scene.materials = {grey(albedo)};
    scene.shapes = {shape(box_of(1, true), 0)};
    scene.lights = {PointLight{Spectrum::constant(3), {0.3, 0.2, -0.1}}};
    return scene;
}

/// Nothing leaves a closed box: walls see emitted / (1 - albedo).
TEST(Ledger, a_closed_box_absorbs_everything) {
    for (const float albedo : {0.0F, 0.5F, 0.8F}) {
        const Ledger ledger = ledger_of(lamp_in_box(albedo), 1000);
        EXPECT_EQ(ledger.escaped, 0);
        EXPECT_EQ(ledger.too_long, 0);
        EXPECT_NEAR(ledger.absorbed, ledger.emitted, 1e-9 * ledger.emitted);
        const double expected = ledger.emitted / (1 - static_cast<double>(albedo));
        EXPECT_NEAR(ledger.arrived, expected, noise(ledger) + 1e-5 * expected) << albedo;
        EXPECT_LT(noise(ledger), 0.02 * expected);
    }
}

/// Cut at depth n: the sum over n arrivals, and albedo^(n - 1) of the paths are cut.
TEST(Ledger, depth_cuts_a_known_share) {
    const double albedo = 0.8;
    for (const int depth : {1, 2, 5}) {
        const Ledger ledger = ledger_of(lamp_in_box(0.8F), depth);
        const double cut = std::pow(albedo, depth - 1);
        const double arrived = (1 - std::pow(albedo, depth)) / (1 - albedo);
        const double spread = 3.3 * ledger.emitted * std::sqrt(cut * (1 - cut) / kPaths);
        EXPECT_NEAR(ledger.too_long, cut * ledger.emitted, spread + 1e-9 * ledger.emitted);
        EXPECT_NEAR(ledger.arrived, arrived * ledger.emitted,
                    noise(ledger) + 1e-5 * ledger.emitted);
        EXPECT_NEAR(ledger.absorbed + ledger.too_long, ledger.emitted, 1e-9 * ledger.emitted);
    }
}

/// Clear glass takes nothing: a ball and a rough block in the box change no sum.
TEST(Ledger, glass_in_the_box_takes_nothing) {
    SceneDescription scene = lamp_in_box(0.5F);
    scene.materials.emplace_back(DielectricMaterial{});
    Matrix aside;
    aside.setTranslation(Vec3d(-0.4, -0.4, 0.1));
    Sphere ball;
    scene.shapes.push_back(shape({ball, Matrix().scale(Vec3d(0.4)) * aside, false}, 1));
    const Ledger ledger = ledger_of(scene, 1000);
    EXPECT_EQ(ledger.escaped, 0);
    EXPECT_EQ(ledger.too_long, 0);
    EXPECT_NEAR(ledger.arrived, 2 * ledger.emitted, noise(ledger) + 1e-5 * ledger.emitted);
}

/// A lamp in the middle of a sphere full of a medium: exp(-a / 2) of its light comes to the wall,
/// a = sigma * diameter, and of what the wall scatters the share 2 (1 - (1 + a) exp(-a)) / a^2
/// comes back to it. What does not arrive, the medium has absorbed.
TEST(Ledger, a_medium_absorbs_what_does_not_arrive) {
    SceneDescription scene;
    scene.materials = {grey(0.8F)};
    scene.shapes = {shape({Sphere{}, Matrix(), true}, 0)};
    scene.shapes[0].media = {0, 1};
    scene.lights = {PointLight{Spectrum::constant(3), {0, 0, 0}}};
    scene.media.all.push_back({Spectrum::constant(0.45F), Spectrum(), 0});
    scene.media.at_lights = {{1, 1}};
    scene.media.at_camera = 1;
    const double a = 2 * 0.45;
    const double back = 2 * (1 - (1 + a) * std::exp(-a)) / (a * a);
    const Ledger ledger = ledger_of(scene, 1000);
    const double expected = ledger.emitted * std::exp(-a / 2) / (1 - 0.8 * back);
    EXPECT_NEAR(ledger.arrived, expected, noise(ledger) + 1e-5 * expected);
    EXPECT_LT(noise(ledger), 0.02 * expected);
    EXPECT_NEAR(ledger.absorbed, ledger.emitted, 1e-9 * ledger.emitted);
    EXPECT_EQ(ledger.escaped + ledger.too_long, 0);
}

/// Around a ball of albedo a in the sun: the disc's light that misses it escapes, and a of the
/// rest.
TEST(Ledger, an_open_scene_lets_the_rest_escape) {
    SceneDescription scene;
    scene.materials = {grey(0.3F)};
    scene.shapes = {shape({Sphere{}, Matrix(), false}, 0)};
    scene.lights = {DistantLight{Spectrum::constant(2), {0, 0, -1}}};
    const Ledger ledger = ledger_of(scene, 64);
    // The scene's sphere is the ball's box's: radius sqrt(3); the ball fills a third of the disc.
    const double met = ledger.arrived / ledger.emitted;
    EXPECT_NEAR(ledger.arrived, 2 * kPiDouble, noise(ledger));
    EXPECT_NEAR(ledger.absorbed, 0.7 * met * ledger.emitted,
                3.3 * ledger.emitted * std::sqrt(0.25 / kPaths));
    EXPECT_NEAR(ledger.absorbed + ledger.escaped, ledger.emitted, 1e-9 * ledger.emitted);
    EXPECT_EQ(ledger.too_long, 0);
}

}  // namespace
}  // namespace sunfleck::engine
