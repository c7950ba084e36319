// Epochs: which pass belongs to which, and how their photon paths are chosen.
#include "planning/learn_epoch.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(Epoch, begins_at_passes_0_16_128_1024) {
    for (const auto& [epoch, first] : {std::pair(0U, 0U), std::pair(1U, 16U), std::pair(2U, 128U),
                                       std::pair(3U, 1024U), std::pair(4U, 8192U)}) {
        EXPECT_EQ(first_pass_of(epoch), first);
        EXPECT_EQ(epoch_of(first), epoch);
        if (first > 0) {
            EXPECT_EQ(epoch_of(first - 1), epoch - 1);
        }
    }
}

/// A floor in the sun, half of its side as given, and what stands on it.
Scene floor_in_the_sun(const std::string& half, const std::string& objects) {
    return scene_of(view("0 -1.2 1.2  0.35 0 0  0 0 1", 20, 32) +
                    "LightSource \"distant\" \"point3 from\" [-.5 0 1] \"point3 to\" [0 0 0]\n" +
                    diffuse("0.5 0.5 0.5") +
                    quad("-" + half + " -" + half + " 0  " + half + " -" + half + " 0  " + half +
                         " " + half + " 0  -" + half + " " + half + " 0") +
                    "AttributeBegin\nTranslate 0 0 .31\n" + objects + "AttributeEnd\n");
}

Epoch learned(const Scene& scene, IndirectLight indirect, bool guide = true) {
    RenderSettings settings;
    settings.transport.indirect = indirect;
    settings.photon.emission_guide = guide;
    return learn_epoch(scene, settings, 0);
}

constexpr const char* kBall = "Material \"dielectric\"\nShape \"sphere\" \"float radius\" .3\n";

TEST(Epoch, aims_all_photons_where_camera_paths_go_on) {
    const Scene scene = floor_in_the_sun("50", kBall);
    EXPECT_FALSE(learned(scene, IndirectLight::photons).strata.at(0).has_full_guide());
    const Epoch sampled = learned(scene, IndirectLight::sampled);
    EXPECT_TRUE(sampled.strata.at(0).has_full_guide());
    EXPECT_GT(sampled.strata.at(0).guided.paths, 0.8 * sampled.paths);
    EXPECT_EQ(paths_of(sampled.strata), sampled.paths);
}

TEST(Epoch, has_few_photons_where_nothing_bends_light) {
    const Scene bare = floor_in_the_sun("50", diffuse("0.5 0.5 0.5") + box({-1, -1, 0}, {0, 0, 1}));
    const Epoch sampled = learned(bare, IndirectLight::sampled);
    EXPECT_LT(sampled.paths, 2000U);
    EXPECT_FALSE(sampled.strata.at(0).has_full_guide());
    const Epoch unguided = learned(floor_in_the_sun("50", kBall), IndirectLight::sampled, false);
    EXPECT_FALSE(unguided.strata.at(0).has_full_guide());
    EXPECT_EQ(unguided.paths, 200'000U);
}

/// Where a path that is guided by the plan may start, and how heavy it is.
std::vector<double> weights_of(const Epoch& epoch) {
    const GuidedPlan& guided = epoch.strata.at(0).guided;
    std::vector<double> weights{guided.most_weight};
    for (int i = 0; i < 50; ++i) {
        const double x = 0.02 * i;
        weights.push_back(guided.map.density({x, 1 - x, 0.5, 0.5, 0.5}));
    }
    return weights;
}

TEST(Epoch, lets_trials_of_its_first_pass_choose_who_brings_indirect_light) {
    const Scene open = floor_in_the_sun("50", kBall);
    RenderSettings settings;
    const Epoch chosen = learn_epoch(open, settings, 0);
    EXPECT_EQ(chosen.transport.indirect, IndirectLight::sampled);
    EXPECT_EQ(learn_epoch(open, settings, 16).transport.indirect, IndirectLight::sampled);
    settings.transport.indirect = IndirectLight::sampled;
    EXPECT_EQ(weights_of(learn_epoch(open, settings, 0)), weights_of(chosen));
}

TEST(Epoch, goes_on_with_what_earlier_ones_have_learned) {
    const Scene scene = floor_in_the_sun("50", kBall);
    RenderSettings settings;
    settings.transport.indirect = IndirectLight::sampled;
    settings.photon.paths_per_pass = 2000;
    const Epoch first = learn_epoch(scene, settings, 0);
    const Epoch second = learn_epoch(scene, settings, 16, {}, &first);
    EXPECT_EQ(weights_of(learn_epoch(scene, settings, 16)), weights_of(second));
    EXPECT_NE(weights_of(first), weights_of(second));
    const Epoch third = learn_epoch(scene, settings, 128, {}, &second);
    EXPECT_EQ(weights_of(learn_epoch(scene, settings, 128, {}, &first)), weights_of(third));
}

/// Small passes do not wait for what they do not ask for; later ones get what they would have had.
TEST(Epoch, of_small_passes_becomes_that_of_others) {
    const Scene scene = procedural("iced-tea", 24);
    RenderSettings settings;
    settings.large_picture = 0;
    settings.photon.paths_per_pass = 5000;
    const Epoch others = learn_epoch(scene, settings, 4);
    EXPECT_TRUE(serves(others, scene, settings, 0));
    EXPECT_FALSE(others.log2_samples.empty()) << "nothing is measured";
    const Epoch small = learn_epoch(scene, settings, 3);
    EXPECT_TRUE(small.log2_samples.empty());
    EXPECT_TRUE(serves(small, scene, settings, 3));
    EXPECT_FALSE(serves(small, scene, settings, 4));
    EXPECT_FALSE(serves(small, scene, settings, 16));
    const Epoch grown = learn_epoch(scene, settings, 4, {}, &small);
    EXPECT_TRUE(serves(grown, scene, settings, 4));
    EXPECT_EQ(grown.log2_samples, others.log2_samples);
    EXPECT_EQ(grown.paths, others.paths);
}

TEST(Epoch, leaves_indirect_light_to_photons_where_nothing_is_learned) {
    const Scene scene = floor_in_the_sun("50", kBall);
    RenderSettings settings;
    settings.photon.sampler = PhotonSampler::uniform;
    EXPECT_EQ(learn_epoch(scene, settings, 0).transport.indirect, IndirectLight::photons);
    settings = {};
    settings.transport.direct = DirectLight::photons;
    EXPECT_FALSE(learn_epoch(scene, settings, 0).transport.goes_beyond_diffuse());
}

}  // namespace
}  // namespace sunfleck::engine
