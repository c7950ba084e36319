// The photon paths of a pass, in budget with its camera paths.
#include "planning/photon_budget.h"

#include "core/parallel.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr std::uint32_t kUsual = 200'000;  // of fewer than half as many pixels

/// Few pixels: photons cost far more than camera paths.
Scene small_room() {
    return procedural("cornell", 24);
}

/// A plate in front of nothing: no photon is of use.
Scene lone_plate() {
    return scene_of(view("0 0 4  0 0 0  0 1 0", 40, 24) +
                    "LightSource \"point\" \"rgb I\" [20 20 20] \"point3 from\" [2 1 2]\n" +
                    diffuse("0.5 0.5 0.5") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0"));
}

/// A white wall that fills a large view, lit by a point.
Scene even_wall() {
    return scene_of(view("0 0 4  0 0 0  0 1 0", 20, 400) +
                    "LightSource \"point\" \"rgb I\" [20 20 20] \"point3 from\" [0 0 3]\n" +
                    diffuse("0.5 0.5 0.5") + quad("-4 -4 0  4 -4 0  4 4 0  -4 4 0"));
}

/// All indirect light by photons, in discs of two pixels, whose noise is less than that of small
/// pictures' discs.
RenderSettings wide_discs() {
    RenderSettings settings;
    settings.camera.radius_pixels = 2;
    settings.transport.indirect = IndirectLight::photons;
    return settings;
}

Epoch learned(const Scene& scene, const RenderSettings& settings, std::uint32_t pass = 16) {
    Epoch epoch = learn_epoch(scene, settings, pass);
    std::uint64_t planned = 0;
    for (const LightStratum& stratum : epoch.strata) planned += stratum.paths();
    EXPECT_EQ(planned, epoch.paths);
    return epoch;
}

TEST(PhotonBudget, spares_photons_that_cost_more_than_they_bring) {
    EXPECT_LE(learned(small_room(), {}).paths, kUsual / 4);
}

// Glass in the sun, of which a splitting's chains have hardly a hundred seeds a pass: refracted
// camera paths make most of the noise, not photons.
TEST(PhotonBudget, spares_photons_of_chains_that_bring_less_than_camera_paths) {
    const Epoch epoch = learned(procedural("diamond", 96), wide_discs());
    ASSERT_FALSE(epoch.strata.front().plan.levels.empty());
    EXPECT_EQ(epoch.paths, kUsual / 4);
}

// A splitting of one set with some 1150 seeds: an eighth of the paths leaves it 140, a
// sixteenth 70.
TEST(PhotonBudget, spares_photons_of_one_set_while_it_keeps_its_seeds) {
    RenderSettings settings = wide_discs();
    settings.photon.emission_guide = false;
    const Epoch epoch = learned(procedural("cognac-0", 48), settings);
    EXPECT_EQ(epoch.strata.front().plan.levels.size(), 1U);
    EXPECT_EQ(epoch.paths, kUsual / 8);
}

TEST(PhotonBudget, takes_a_part_of_all_that_a_plan_has) {
    LightStratum stratum{};
    stratum.plan = {1000, {{3, 400, 40, {}}, {kVisible, 800, 2, {}}}};
    const std::vector<LightStratum> parts = fraction_of({stratum, stratum}, 4);
    ASSERT_EQ(parts.size(), 2U);
    const SplittingPlan expected{250, {{3, 100, 10, {}}, {kVisible, 200, 1, {}}}};
    EXPECT_EQ(parts.front().plan, expected);
    EXPECT_EQ(parts.front().guided.paths, 0U);  // no map: none through it
    EXPECT_EQ(paths_of(parts), 2 * 550U);
}

// They may bring what was not found yet.
TEST(PhotonBudget, spares_none_while_they_have_found_nothing) {
    EXPECT_EQ(learned(lone_plate(), {}).paths, kUsual);
}

TEST(PhotonBudget, adds_photons_where_they_bring_all_the_noise) {
    constexpr std::uint32_t kUsualHere = 2 * 160'000;
    RenderSettings settings;
    settings.transport.direct = DirectLight::photons;
    const Epoch epoch = learned(even_wall(), settings);
    EXPECT_GE(epoch.paths, 2 * kUsualHere);
    EXPECT_EQ(epoch.subpasses, 1U);
}

TEST(PhotonBudget, has_more_subpasses_where_one_is_worth_less) {
    const Epoch epoch = learned(procedural("cornell", 128), {});
    EXPECT_GT(epoch.subpasses, 1U);
    EXPECT_LT(epoch.subpasses * epoch.paths, kUsual);  // or nothing would be gained
}

TEST(PhotonBudget, holds_for_an_epoch_whatever_the_threads) {
    const Scene scene = small_room();
    const std::uint32_t paths = learned(scene, {}).paths;
    EXPECT_NE(paths, kUsual);
    for (const std::size_t threads : {1U, 3U}) {
        const ThreadLimit limit(threads);
        EXPECT_EQ(learned(scene, {}, 77).paths, paths);
    }
}

TEST(PhotonBudget, is_not_asked_in_the_first_epoch_or_where_the_number_is_given) {
    const Scene scene = small_room();
    RenderSettings settings;
    settings.transport.indirect = IndirectLight::photons;
    EXPECT_EQ(learned(scene, settings, 15).paths, kUsual);
    settings.photon.photon_budget = false;
    EXPECT_EQ(learned(scene, settings).paths, kUsual);
    settings.photon.photon_budget = true;
    settings.photon.paths_per_pass = 1234;
    EXPECT_EQ(learned(scene, settings).paths, 1234U);
    settings.photon.paths_per_pass.reset();
    settings.photon.sampler = PhotonSampler::uniform;
    EXPECT_EQ(learned(scene, settings).paths, kUsual);
}

// A black picture says nothing.
TEST(PhotonBudget, spends_no_photons_on_a_dark_scene) {
    EXPECT_EQ(learned(scene_of(view("0 0 4  0 0 0  0 1 0", 40, 8) + diffuse("0.5 0.5 0.5") +
                               quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0")),
                      {})
                  .paths,
              0U);
}

}  // namespace
}  // namespace sunfleck::engine
