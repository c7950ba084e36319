// Radiance and density of the emitters that a ray meets, by hand.
#include "camera_paths/emitter_hits.h"

#include "support/direct_light_cases.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// What emitter_at() says: the side that shines, the lamp's own radiance and density.
TEST(EmitterHits, emitter_at_a_hit) {
    SceneDescription description = floor_of();
    description.shapes.push_back(lamp(quad(kCeiling), 2));
    const LitPoint point(std::move(description));
    const Scene& scene = point.scene();
    const Vec3 from(kPoint);
    const auto met = [&](const Vec3& origin, const Vec3& direction) {
        const auto hit = scene.geometry().intersect({origin, direction, kInfinity});
        const Receiver at{origin, Vec3(0)};
        return emitter_at(point.pass(), hit.value(), &at, direction);
    };
    const EmitterMet front = met(from + Vec3(0, 0, 0.5F), {0, 0, 1});
    EXPECT_EQ(front.radiance, SampledSpectrum(2));
    // Two triangles of area 2 and equal power: distance^2 / (cos * 2) / 2.
    EXPECT_NEAR(front.pdf, 1.5 * 1.5 / 2 / 2, 1e-5);
    EXPECT_TRUE(met(from + Vec3(0, 0, 3), {0, 0, -1}).radiance.is_zero());
    EXPECT_TRUE(met(from + Vec3(5, 0, 1), {0, 0, -1}).radiance.is_zero());
}

/// All infinite lights at once, with the density of light samples of any of them.
TEST(EmitterHits, emitters_beyond) {
    SceneDescription scene = floor_of();
    scene.shapes.push_back(lamp(quad(kCeiling), 2));
    for (const float radiance : {0.1F, 0.3F, 0.2F})
        scene.lights.emplace_back(InfiniteLight{Spectrum::constant(radiance)});
    const LitPoint point(std::move(scene));
    const LightTree& tree = point.scene().light_tree();
    const double skies =
        tree.probability({}, 2) + tree.probability({}, 3) + tree.probability({}, 4);
    const EmitterMet met = emitter_beyond(point.pass(), Vec3(kPoint), {0, 0, 1});
    EXPECT_FLOAT_EQ(met.radiance[0], 0.6F);
    EXPECT_NEAR(met.pdf, skies / (4 * kPiDouble), 1e-7);
}

}  // namespace
}  // namespace sunfleck::engine
