// Worth guides: photon paths through them find what uniform ones hardly find, and bring the same.
#include "planning/worth_guide.h"

#include "photon_samplers/uniform_sampler.h"
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

/// The photons of a pass whose camera paths go on beyond diffuse surfaces.
class PhotonsOf {
public:
    explicit PhotonsOf(const Scene& scene) : scene_(scene), pass_(scene, {1, 0}) {
        transport_.indirect = IndirectLight::sampled;
    }

    EmissionGuide guide() const { return learned_worth_guide(context_, window_, seen_, {1, 0}); }

    /// @param guide  the identity: uniform paths.
    Photons traced(const EmissionGuide& guide, std::uint32_t number, std::uint32_t paths) const {
        LightStratum stratum{scene_.light_choice(), {}, {}};
        if (guide.is_identity())
            stratum.plan.uniform_paths = paths;
        else
            stratum.guided = {guide, paths, 1, 1};
        const std::vector<LightStratum> strata = {stratum};
        const PhotonPass photons{context_, {3, number}, strata, {}};
        PassImage image(window_.pixels(), {});
        PhotonTotals totals;
        if (guide.is_identity())
            trace_uniform_stratum(photons, UniformKind::uniform, stratum, {image}, totals);
        else
            trace_guided_stratum(photons, stratum, {image}, totals);
        return {static_cast<double>(totals.statistics[Count::visible_states]) / paths,
                mean_value(luminance_of(image))};
    }

private:
    const Scene& scene_;
    PassScene pass_;
    TransportSettings transport_;
    CameraPathSettings camera_;
    PixelWindow window_ = window_of(scene_.film());
    CameraTrial seen_ = view_of({pass_, transport_, camera_, window_, {1, 0}});
    PhotonContext context_{pass_, transport_, seen_.index};
};

/// On a small floor uniform photons converge: the ratio of both is one within 3% at 99%. So many
/// more of them have several times the error.
TEST(WorthGuide, brings_what_uniform_paths_bring) {
    const Scene scene = ball(0.7);
    const PhotonsOf photons(scene);
    const EmissionGuide guide = photons.guide();
    constexpr int kRenders = 40;
    const auto light = [&](const EmissionGuide& through, std::uint32_t paths) {
        return Estimate::over(kRenders, [&](int i) {
            return photons.traced(through, static_cast<std::uint32_t>(i), paths).light;
        });
    };
    const Estimate guided = light(guide, 20'000);
    const Estimate uniform = light({}, 280'000);
    EXPECT_LT(worst_ratio(guided, uniform), 0.03)
        << guided.mean / uniform.mean << ", errors " << guided.error / guided.mean << ' '
        << uniform.error / uniform.mean;
    EXPECT_LT(guided.error, uniform.error);
}

/// However large the floor around the view, photons are aimed at the ball: a million times the area
/// costs half of those that are visible.
TEST(WorthGuide, does_not_mind_what_is_not_seen) {
    const Scene small = ball(1.5);
    const PhotonsOf near(small);
    const double visible = near.traced(near.guide(), 0, 20'000).visible;
    EXPECT_GT(visible, 0.15);
    for (const double half : {15.0, 1500.0}) {
        const Scene scene = ball(half);
        const PhotonsOf photons(scene);
        EXPECT_GT(photons.traced(photons.guide(), 0, 20'000).visible, 0.4 * visible) << half;
    }
}

TEST(WorthGuide, is_the_identity_where_nothing_bends_light) {
    const Scene scene = scene_of(view("0 -1 1  0 0 0  0 0 1", 20, 8) +
                                 "LightSource \"distant\" \"rgb L\" [2 2 2]\n" +
                                 diffuse("0.5 0.5 0.5") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0"));
    EXPECT_TRUE(PhotonsOf(scene).guide().is_identity());
}

}  // namespace
}  // namespace sunfleck::engine
