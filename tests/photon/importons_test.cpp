// Walks find lights whatever wavelengths their pass has.
#include "photon/importons.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

struct LightFound {
    std::size_t guide_samples = 0;
    double seen = 0;
    bool is_dark = false;  // at the wavelengths of the pass
};

/// From a point of a white floor below a sun of that colour.
LightFound found_of(const Spectrum& sun) {
    TriangleMesh floor;
    floor.positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    SceneDescription description;
    description.materials = {DiffuseMaterial{Spectrum::constant(1)}};
    description.shapes = {{{floor, Matrix(), false}, 0, {}, {}}};
    description.lights = {DistantLight{sun, {0, 0, -1}}};
    const Scene scene(description);
    const PassId id{1, 0};
    const PassScene pass(scene, id);
    VisiblePoint point;
    point.disc.radius = 0.1F;
    point.disc.normal = {0, 0, 1};
    point.disc.kinds = static_cast<std::uint8_t>(PhotonKind::direct);
    const TransportSettings transport;
    const VisiblePointIndex index({{point}}, 8);
    const PhotonContext view{pass, transport, index};
    const WalkedEmission found = trace_importons(view, scene.light_choice(), id, {0, 1000});
    return {found.guide_samples.size(), flux_seen(view, id), pass.emission[0].is_zero()};
}

/// Few passes meet a lamp of 585 to 590 nm. Where one is dark it counts as if it were grey.
TEST(Importons, find_a_light_that_is_dark_in_their_pass) {
    const LightFound white = found_of(Spectrum::constant(1));
    ASSERT_FALSE(white.is_dark);
    EXPECT_GT(white.guide_samples, 900U);
    const auto sodium = Spectrum::table({{585, 0}, {586, 1}, {589, 1}, {590, 0}});
    const LightFound dark = found_of(sodium);
    ASSERT_TRUE(dark.is_dark);
    EXPECT_EQ(dark.guide_samples, white.guide_samples);
    EXPECT_NEAR(dark.seen / white.seen, static_cast<double>(sodium.luminance()),
                1e-4 * static_cast<double>(sodium.luminance()));
}

}  // namespace
}  // namespace sunfleck::engine
