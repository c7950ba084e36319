// Query and deposit agree: the index says "visible" of a photon if and only if some visible point
// accepts it, on whole passes, and it misses none.
#include "camera_paths/trace_camera_paths.h"
#include "photon/tracer.h"
#include "random_numbers/emission_points.h"
#include "support/gather_tests.h"
#include "support/procedural.h"
#include "support/renders.h"
#include "support/visible_points.h"
#include "visible_points/visible_point_index.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr PassId kId{9, 0};

/// The visible points of a pass, in the order of the index and in their own.
struct Points {
    Points(const PassScene& pass, const RenderSettings& settings, Statistics& counts)
        : window(window_of(pass.scene.film())),
          image(window.pixels(), {}),
          list(joined(trace_camera_paths(
              {pass, settings.transport, settings.camera, window, kId, 1}, image, counts))),
          max_depth(settings.transport.max_depth),
          index({list}, max_depth) {}

    std::uint64_t one_by_one(const Photon& photon) const {
        return static_cast<std::uint64_t>(std::count_if(
            list.begin(), list.end(),
            [&](const VisiblePoint& p) { return accepts(p.disc, photon, max_depth); }));
    }

    /// Points that take the photon, as the index has it; compared with `thorough` one by one.
    std::uint64_t accepting(const Photon& photon, bool thorough) const {
        std::uint64_t count = 0;
        const bool taken = testing_support::for_each_accepting(
            index, photon, [&](const VisiblePoint&) { ++count; });
        EXPECT_EQ(taken, count > 0);
        EXPECT_EQ(taken, index.any(photon));
        EXPECT_TRUE(!taken || index.may_accept(photon));
        if (thorough) {
            EXPECT_EQ(one_by_one(photon), count);
        }
        return count;
    }

    PixelWindow window;
    PassImage image;
    std::vector<VisiblePoint> list;
    int max_depth;
    VisiblePointIndex index;
};

/// What a pass deposits, counted again: every photon asks the index, each eleventh all points.
Statistics counted_again(const Scene& scene, const RenderSettings& settings) {
    const PassScene pass(scene, kId);
    Statistics counts;
    const Points points(pass, settings, counts);
    const PhotonTracer tracer(pass, settings.transport);
    const EmissionPoints emission(kId);
    std::uint64_t asked = 0;
    for (std::uint32_t i = 0; i < *settings.photon.paths_per_pass; ++i) {
        std::uint64_t deposits = 0;
        const auto visit = [&](const Photon& photon) {
            const std::uint64_t accepting = points.accepting(photon, asked++ % 11 == 0);
            counts[Count::photons_stored] += accepting > 0 ? 1 : 0;
            deposits += accepting;
            return true;
        };
        std::uint64_t rays = 0;
        tracer.trace(emission.path(i), visit, rays);
        counts[Count::deposits] += deposits;
        counts[Count::uniform_visible] += deposits > 0 ? 1 : 0;
    }
    return counts;
}

void expect_agreement(const Scene& scene, std::uint32_t paths) {
    for (const DirectLight direct : {DirectLight::sampled, DirectLight::photons}) {
        RenderSettings settings;
        settings.seed = kId.seed;
        settings.transport.direct = direct;
        settings.photon.sampler = PhotonSampler::uniform;
        settings.photon.paths_per_pass = paths;
        settings.camera.edges = false;  // V does not ask for sight
        const Statistics queried = counted_again(scene, settings);
        const Statistics deposited = render_pass(scene, settings, kId.number).statistics;
        EXPECT_GT(queried[Count::photons_stored], 40U);
        for (const Count which : {Count::visible_points, Count::photons_stored, Count::deposits,
                                  Count::uniform_visible})
            EXPECT_EQ(queried[which], deposited[which]);
    }
}

/// Among them small balls, about which a disc bends far out of its plane.
TEST(Visibility, glossy_diffuse_and_round_surfaces) {
    std::string balls;
    for (const char* x : {"-.6", "-.3", "0", ".3", ".6"})
        balls += std::string("AttributeBegin\nTranslate ") + x +
                 " -2 .6\nShape \"sphere\" \"float radius\" .12\nAttributeEnd\n";
    expect_agreement(scene_of(view("0 -4 1.5  0 0 .5  0 0 1", 40, 24) +
                              "LightSource \"point\" \"point3 from\" [0 -3 2]\n" +
                              diffuse(".7 .7 .7") + balls + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") +
                              "Material \"dielectric\" \"float roughness\" 0.1\n" +
                              box({-1.2, -.5, .2}, {-.2, .5, 1}) + "Material \"dielectric\"\n" +
                              box({.2, -.5, .2}, {1.2, .5, 1}) +
                              "Material \"conductor\" \"float roughness\" .1\n" +
                              quad("-1 1 0  1 1 0  1 1.4 2  -1 1.4 2")),
                     20'000);
}

/// A glass of the project's own scenes.
TEST(Visibility, cognac) {
    expect_agreement(procedural("cognac-1", 24), 40'000);
}

}  // namespace
}  // namespace sunfleck::engine
