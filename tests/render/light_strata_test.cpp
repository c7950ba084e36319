// Strata of lights in a real scene: two lamps, of which little of the stronger one is seen.
#include "core/parallel.h"
#include "support/two_lamps.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

RenderSettings settings(std::uint64_t seed, std::uint32_t paths = 20'000) {
    RenderSettings settings;
    settings.seed = seed;
    settings.photon.paths_per_pass = paths;
    settings.transport.indirect = IndirectLight::photons;
    return settings;
}

std::vector<LightStratum> learned(const Scene& scene, std::uint64_t seed, std::uint32_t pass = 0) {
    return learn_epoch(scene, settings(seed), pass).strata;
}

bool are_equal(const std::vector<LightStratum>& a, const std::vector<LightStratum>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.plan == y.plan && x.power_share == y.power_share && x.number == y.number &&
               x.lights.total() == y.lights.total();
    });
}

bool are_equal(const PassResult& a, const PassResult& b) {
    for (std::size_t i = 0; i < a.image.pixels(); ++i)
        if (pixel_value(a.image, i) != pixel_value(b.image, i)) return false;
    return a.statistics == b.statistics && a.visible_fraction == b.visible_fraction;
}

TEST(LightStrata, part_a_lamp_that_is_hardly_seen) {
    const Scene scene = two_lamps(16);
    const std::vector<LightStratum> strata = learned(scene, 1);
    ASSERT_EQ(strata.size(), 2U);
    EXPECT_EQ(strata[0].number, 0U);
    EXPECT_EQ(strata[1].number, 1U);
    // Radiances 20 and 400, areas 1 and 100: shares 1/2001 and 2000/2001.
    EXPECT_NEAR(strata[0].power_share, 1.0 / 2001, 1e-6);
    EXPECT_NEAR(strata[1].power_share, 2000.0 / 2001, 1e-6);
    std::uint64_t paths = 0;
    for (const LightStratum& stratum : strata) paths += stratum.paths();
    EXPECT_EQ(paths, 20'000U);
    EXPECT_TRUE(strata[0].plan.levels.empty());
    EXPECT_FALSE(strata[1].plan.levels.empty());
    // Two triangles a lamp; those of the other are never chosen.
    for (std::size_t light = 0; light < 4; ++light) {
        EXPECT_NEAR(strata[0].lights.probability(light), light < 2 ? 0.5 : 0, 1e-9);
        EXPECT_NEAR(strata[1].lights.probability(light), light < 2 ? 0 : 0.5, 1e-9);
    }
}

TEST(LightStrata, are_the_same_for_any_number_of_threads_and_others_for_other_names) {
    const Scene scene = two_lamps(16);
    const std::vector<LightStratum> first = learned(scene, 1);
    for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
        const ThreadLimit limit(threads);
        EXPECT_TRUE(are_equal(learned(scene, 1), first)) << threads;
    }
    EXPECT_TRUE(are_equal(learned(scene, 1, 15), first));
    EXPECT_FALSE(are_equal(learned(scene, 2), first));
    EXPECT_FALSE(are_equal(learned(scene, 1, 16), first));
}

/// The plain splitting over all lights, and its bytes, where there is nothing to part.
TEST(LightStrata, one_source_and_lamps_seen_alike_are_one_stratum_as_without) {
    const std::string room = view("0 0 2.5  0 0 0  0 1 0", 60, 8) + diffuse("0.5 0.5 0.5") +
                             quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
                             "AreaLightSource \"diffuse\" \"rgb L\" [5 5 5]\n";
    const std::string left = quad("-.9 -.9 2  -.9 .9 2  -.5 .9 2  -.5 -.9 2");
    const std::string right = quad(".5 -.9 2  .5 .9 2  .9 .9 2  .9 -.9 2");
    for (const std::string& lamps : {left, left + right}) {
        const Scene scene = scene_of(room + lamps);
        RenderSettings together = settings(1);
        together.photon.light_strata = false;
        EXPECT_EQ(learned(scene, 1).size(), 1U);
        const PassResult pass = render_pass(scene, settings(1), 3);
        EXPECT_GT(pass.statistics[Count::deposits], 0U);
        EXPECT_TRUE(are_equal(pass, render_pass(scene, together, 3)));
    }
    RenderSettings together = settings(1);
    together.photon.light_strata = false;
    const Scene scene = two_lamps(8);
    EXPECT_FALSE(are_equal(render_pass(scene, settings(1), 3), render_pass(scene, together, 3)));
}

TEST(LightStrata, need_two_paths_each) {
    const Scene scene = two_lamps(8);
    EXPECT_EQ(learn_epoch(scene, settings(1, 3), 0).strata.size(), 1U);
    const std::vector<LightStratum> strata = learn_epoch(scene, settings(1, 4), 0).strata;
    ASSERT_EQ(strata.size(), 2U);
    EXPECT_EQ(strata[0].plan.paths(), 2U);
    EXPECT_EQ(strata[1].plan.paths(), 2U);
}

TEST(LightStrata, of_no_light_are_none) {
    const Scene scene = scene_of(view("0 0 2.5  0 0 0  0 1 0", 60, 8) + diffuse("0.5 0.5 0.5") +
                                 quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0"));
    EXPECT_TRUE(learned(scene, 1).empty());
}

/// The fraction of the whole is that of uniform paths from all lights, and counts add up.
TEST(LightStrata, counts_of_a_pass_are_those_of_its_strata) {
    const Scene scene = two_lamps(16);
    const PassResult pass = render_pass(scene, settings(1), 0);
    ASSERT_EQ(pass.strata.size(), 2U);
    const StratumCounts& lamp = pass.strata[0];
    const StratumCounts& above = pass.strata[1];
    EXPECT_GT(above.visible_fraction, 0);
    EXPECT_GT(lamp.visible_fraction, 30 * above.visible_fraction);
    EXPECT_DOUBLE_EQ(pass.visible_fraction, lamp.power_share * lamp.visible_fraction +
                                                above.power_share * above.visible_fraction);
    EXPECT_TRUE(lamp.splitting.levels.empty());
    ASSERT_FALSE(above.splitting.levels.empty());
    EXPECT_EQ(pass.statistics[Count::uniform_paths], lamp.paths + above.splitting.levels[0].states);
    EXPECT_EQ(pass.statistics[Count::accepted_paths], above.splitting.mutations().accepted);
}

}  // namespace
}  // namespace sunfleck::engine
