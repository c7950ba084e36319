// Worth guides: photon paths through them find what uniform ones hardly find, and bring the same.
#include "planning/worth_guide.h"

#include "photon_samplers/splitting_sampler.h"
#include "planning/learn_epoch.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A ball of glass on a floor in the sun, seen close up. @param half  of the floor's side.
Scene ball(double half) {
    const std::string h = std::to_string(half);
    return scene_of(view("0 -1.2 1.2  0.35 0 0  0 0 1", 20, 24) +
                    "LightSource \"distant\" \"point3 from\" [-.5 0 1] \"point3 to\" [0 0 0] "
                    "\"rgb L\" [2 2 2]\n" +
                    diffuse("0.5 0.5 0.5") +
                    quad("-" + h + " -" + h + " 0  " + h + " -" + h + " 0  " + h + " " + h +
                         " 0  -" + h + " " + h + " 0") +
                    "AttributeBegin\nTranslate 0 0 .31\nMaterial \"dielectric\"\n"
                    "Shape \"sphere\" \"float radius\" .3\nAttributeEnd\n");
}

struct Photons {
    double visible = 0;  // share of the paths
    double light = 0;    // mean of the picture
};

/// What photons bring, not what discs lose.
CameraPathSettings without_edges() {
    CameraPathSettings settings;
    settings.edges = false;
    return settings;
}

/// The photons of a pass whose camera paths go on beyond diffuse surfaces.
class PhotonsOf {
public:
    explicit PhotonsOf(const Scene& scene) : scene_(scene), pass_(scene, {1, 0}) {
        transport_.indirect = IndirectLight::sampled;
    }

    EmissionGuide guide() const {
        return learned_worth_guide(context_, window_, seen_, {1, 0},
                                   {200'000, Objective::relative, {}})
            .plan.map;
    }

    LightStratum uniform(std::uint32_t paths) const {
        return {scene_.light_choice(), {paths, {}}, {}};
    }
    LightStratum through(const EmissionGuide& guide, std::uint32_t paths) const {
        return {scene_.light_choice(), {}, {guide, paths}};
    }
    /// With the bound of weights, and chains that bring what it leaves.
    LightStratum learned(std::uint32_t parts, std::uint32_t seed = 0) const {
        RenderSettings settings;
        settings.seed = seed;
        settings.transport = transport_;
        settings.camera = camera_;
        return fraction_of(learn_epoch(scene_, settings, 0).strata, parts).at(0);
    }

    Photons traced(const LightStratum& stratum, std::uint32_t number) const {
        const std::vector<LightStratum> strata = {stratum};
        PassImage image(window_.pixels(), {});
        NoState none;
        const PhotonTotals totals =
            SplittingSampler::trace({context_, {3, number}, strata, {}}, {image}, none);
        return {static_cast<double>(totals.statistics[Count::visible_states]) /
                    static_cast<double>(stratum.paths()),
                mean_value(luminance_of(image))};
    }

private:
    const Scene& scene_;
    PassScene pass_;
    TransportSettings transport_;
    CameraPathSettings camera_ = without_edges();
    PixelWindow window_ = window_of(scene_.film());
    CameraTrial seen_ = view_of({pass_, transport_, camera_, window_, {1, 0}});
    PhotonContext context_{pass_, transport_, seen_.index};
};

/// On a small floor uniform photons converge: the ratio of both is one within 3% at 99%. So many
/// more of them have several times the error.
TEST(WorthGuide, brings_what_uniform_paths_bring) {
    const Scene scene = ball(0.7);
    const PhotonsOf photons(scene);
    constexpr int kRenders = 40;
    const auto light = [&](const LightStratum& stratum) {
        return Estimate::over(kRenders, [&](int i) {
            return photons.traced(stratum, static_cast<std::uint32_t>(i)).light;
        });
    };
    const Estimate uniform = light(photons.uniform(280'000));
    const LightStratum learned = photons.learned(5);
    EXPECT_LT(learned.guided.most_weight, kUnbounded);
    ASSERT_EQ(learned.plan.levels.size(), 1U);
    for (const LightStratum& stratum : {photons.through(photons.guide(), 20'000), learned}) {
        const Estimate guided = light(stratum);
        EXPECT_LT(worst_ratio(guided, uniform), 0.03)
            << guided.mean / uniform.mean << ", errors " << guided.error / guided.mean << ' '
            << uniform.error / uniform.mean;
        EXPECT_LT(guided.error, uniform.error);
    }
}

/// However large the floor around the view, photons are aimed at the ball: a million times the area
/// costs half of those that are visible.
TEST(WorthGuide, does_not_mind_what_is_not_seen) {
    const Scene small = ball(1.5);
    const PhotonsOf near(small);
    const double visible = near.traced(near.through(near.guide(), 20'000), 0).visible;
    EXPECT_GT(visible, 0.15);
    for (const double half : {15.0, 1500.0}) {
        const Scene scene = ball(half);
        const PhotonsOf photons(scene);
        EXPECT_GT(photons.traced(photons.through(photons.guide(), 20'000), 0).visible,
                  0.4 * visible)
            << half;
    }
}

/// Light deep in the shadow of a glass, by few ways through it: hardly a sample of casters is
/// visible. Chains find these ways, so that no seed has to be lucky.
TEST(WorthGuide, begins_where_chains_have_been) {
    const Scene scene = procedural("cognac-6", 32);
    const PhotonsOf photons(scene);
    for (const std::uint32_t seed : {1U, 2U, 3U})
        EXPECT_GT(photons.traced(photons.learned(5, seed), 0).visible, 0.15) << seed;
}

TEST(WorthGuide, is_the_identity_where_nothing_bends_light) {
    const Scene scene = scene_of(view("0 -1 1  0 0 0  0 0 1", 20, 8) +
                                 "LightSource \"distant\" \"rgb L\" [2 2 2]\n" +
                                 diffuse("0.5 0.5 0.5") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0"));
    EXPECT_TRUE(PhotonsOf(scene).guide().is_identity());
}

}  // namespace
}  // namespace sunfleck::engine
