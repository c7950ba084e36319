// Laws of every sampler: what it is asked for it gives on average, and nothing but its arguments
// decides what it gives.
//
// Seed 1. The means have 99.9% intervals that must lie within `quick_band` of the truth, 1% for
// most: that is about the smallest bias that is seen.
#include "laws/sampler_laws.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::laws {
namespace {

SamplerExample example_named(const std::string& name) {
    for (const SamplerExample& example : sampler_examples())
        if (example.name == name) return example;
    throw std::out_of_range(name);
}

class SamplerLaws : public testing::TestWithParam<SamplerExample> {};

TEST_P(SamplerLaws, estimates_are_unbiased) {
    const SamplerExample& example = GetParam();
    expect_unbiased(example, 1, example.passes.quick, 0.999, example.quick_band);
}

/// States and chains as planned; all in their set; each step counted; weights add up to b.
TEST_P(SamplerLaws, counts_are_what_the_plan_says) {
    const SplittingPlan& plan = GetParam().plan;
    for (std::uint32_t p = 0; p < 20; ++p) {
        const PassSums sums = run_pass(GetParam(), {1, p});
        EXPECT_NEAR(sums.weight, sums.visible_fraction, 1e-9);
        if (plan.levels.empty()) continue;
        const auto& levels = sums.counts.levels;
        EXPECT_EQ(levels.at(0).states, plan.uniform_paths);
        EXPECT_EQ(levels.at(0).distinct, plan.uniform_paths);
        EXPECT_EQ(levels.at(0).at_least(0), plan.uniform_paths);
        if (plan.uniform_paths > 0) {
            EXPECT_EQ(sums.counts.survivors.at(0), levels[0].at_least(plan.levels[0].height));
        }
        for (std::size_t k = 1; k < levels.size(); ++k) {
            const LevelPlan& planned = plan.levels[k - 1];
            const Acceptances& kinds = levels[k].acceptances;
            EXPECT_EQ(levels[k].states, planned.states);
            EXPECT_EQ(levels[k].at_least(planned.height), planned.states);
            EXPECT_EQ(kinds[0].proposed + kinds[1].proposed, planned.states - planned.chains);
            EXPECT_EQ(kinds[0].accepted + kinds[1].accepted, levels[k].distinct - planned.chains);
            if (k == plan.levels.size()) continue;
            EXPECT_EQ(sums.counts.survivors.at(k), levels[k].at_least(plan.levels[k].height));
        }
    }
}

TEST_P(SamplerLaws, same_bytes_for_any_number_of_threads) {
    std::vector<std::uint64_t> bytes;
    for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
        const ThreadLimit limit(threads);
        std::uint64_t all = 0;
        for (std::uint32_t p = 0; p < 5; ++p)
            all = all * 0x9E3779B97F4A7C15 + bytes_of(run_pass(GetParam(), {1, p}));
        bytes.push_back(all);
    }
    for (const std::uint64_t b : bytes) EXPECT_EQ(b, bytes[0]);
}

TEST_P(SamplerLaws, a_pass_does_not_know_the_passes_before) {
    const std::uint64_t first = bytes_of(run_pass(GetParam(), {1, 3}));
    for (std::uint32_t p = 0; p < 3; ++p) run_pass(GetParam(), {1, p});
    EXPECT_EQ(bytes_of(run_pass(GetParam(), {1, 3})), first);
}

TEST_P(SamplerLaws, passes_and_seeds_differ) {
    const std::uint64_t bytes = bytes_of(run_pass(GetParam(), {1, 0}));
    EXPECT_NE(bytes_of(run_pass(GetParam(), {1, 1})), bytes);
    EXPECT_NE(bytes_of(run_pass(GetParam(), {2, 0})), bytes);
}

INSTANTIATE_TEST_SUITE_P(All, SamplerLaws, testing::ValuesIn(sampler_examples()),
                         [](const auto& info) { return info.param.name; });

/// Brightness of a picture is b: stratified points must make it far steadier than random ones, and
/// the error of the mean of P passes must fall as 1 / P, which it does not with one shift for all.
/// Seed 1; a ratio of variances of 400 passes each is known within 10% (one standard error).
TEST(SobolPoints, vary_less_and_afresh) {
    const SamplerExample stratified = example_named("sobol_points");
    SamplerExample random = stratified;
    random.sobol = false;
    const Ratios even = run_passes(stratified, 1, 400);
    EXPECT_LT(even.visible_fraction.variance(),
              0.5 * run_passes(random, 1, 400).visible_fraction.variance());
    RunningMean of_sixteen;
    for (std::uint32_t i = 0; i < 400; ++i)
        of_sixteen.add(run_passes(stratified, 100 + i, 16).visible_fraction.mean());
    const double ratio = 16 * of_sixteen.variance() / even.visible_fraction.variance();
    EXPECT_GT(ratio, 0.6);
    EXPECT_LT(ratio, 1.6);
}

/// Of steps too small to leave an island, the seeds alone say how the islands share the light: with
/// a thirtieth of the chains the variance is several times as large. Seed 1, 400 passes: known
/// within 10% (one standard error).
TEST(OneSet, every_seed_counts) {
    SamplerExample example = example_named("one_set_thousands_of_seeds");
    LevelPlan& level = example.plan.levels[0];
    example.plan.uniform_paths = 1024;
    level.states = 1024;
    level.scales.scale = {0.01F, 0.01F};
    level.chains = 300;  // as many as there are seeds
    const double all = run_passes(example, 1, 400).flux.variance();
    level.chains = 10;
    EXPECT_LT(3 * all, run_passes(example, 1, 400).flux.variance()) << all;
}

}  // namespace
}  // namespace sunfleck::engine::laws
