// Examples of every sampler, which the laws of tests/laws/sampler_laws_*test.cpp run over.
#pragma once

#include "laws/sampler_runs.h"

#include <memory>

namespace sunfleck::engine::laws {

using testing_support::first_dimensions;

/// A splitting over nested sets of these heights.
/// @param scale  of mutations, both kinds.
inline SplittingPlan plan_over(const std::vector<int>& heights, std::uint32_t uniform,
                               std::uint32_t states, std::uint32_t chains, float scale) {
    SplittingPlan plan{uniform, {}};
    for (const int height : heights) {
        LevelPlan& level = plan.levels.emplace_back();
        level.height = height;
        level.states = states;
        level.chains = chains;
        level.scales.scale = {scale, scale / 4};
    }
    return plan;
}

/// The `sets` greatest heights.
inline std::vector<int> top(int sets) {
    std::vector<int> heights;
    for (int k = 1; k <= sets; ++k) heights.push_back(kVisible - sets + k);
    return heights;
}

/// Starts of paths whose first dimension lies in [low, high].
inline std::vector<WeightedEmission> starts_over(double low, double high) {
    RandomStream random(3, Purpose::test, 0, 0);
    std::vector<WeightedEmission> starts;
    for (int i = 0; i < 4000; ++i) {
        WeightedEmission& start = starts.emplace_back();
        for (double& x : start.point) x = random.next();
        start.point[0] = low + (high - low) * start.point[0];
    }
    return starts;
}

/// A map that covers places where the first dimension lies in [low, high], and nothing else.
/// @param importance  to the chains, of what it covers. @param own_share  of the light from there.
inline GuidedPlan guided_over(double low, double high, std::uint32_t paths, double importance,
                              double own_share) {
    const std::vector<WeightedEmission> starts = starts_over(low, high);
    std::vector<EmissionGuide::Trial> trials;
    for (const WeightedEmission& start : starts) trials.push_back({start.point, true});
    return {EmissionGuide::learned(starts, {0.25}).where_visible(trials, 0.5), paths, importance,
            own_share};
}

/// A mixture of two maps of full support: most paths start where the first dimension lies in
/// [.14,.3], some in [.66,.7]. @param most_weight  of a path.
inline GuidedPlan bounded(std::uint32_t paths, double most_weight) {
    const auto other = std::make_shared<const EmissionGuide>(
        EmissionGuide::learned(starts_over(0.66, 0.7), {0.75}));
    return {EmissionGuide::learned(starts_over(0.14, 0.3), {0.75}).mixed_with(other, 0.1), paths, 1,
            1, most_weight};
}

/// Passes are as many as the bands of the laws need.
inline std::vector<SamplerExample> sampler_examples() {
    const Islands two{"two", {0, 6}, {{0.25, 0.2, 0.5, 1}, {0.7, 0.18, 0.5, 2}}};
    const Islands eight{"eight", first_dimensions(8), {{0.3, 0.2, 0.49, 1}, {0.8, 0.19, 0.49, 2}}};
    Islands line{"line", {0, 6}, {{0.2, 0.09, 0.5, 1}, {0.7, 0.07, 0.5, 2}}, 1};
    line.growth = 1.2;
    Islands emission = line;  // reads all that maps are made of
    emission.dimensions = {0, 6, 1, 2, 3, 4};
    Islands many{"many", first_dimensions(64), {{0.2, 0.1, 0.499, 1}, {0.7, 0.07, 0.499, 2}}, 1};
    many.growth = 1.4;
    const Islands sticky{
        "sticky", first_dimensions(3), {{0.2, 0.1, 0.5, 1}, {0.7, 0.004, 0.5, 2}}, 1};
    const NestedBoxes nested{"nested", {{0.3, 0.3}, {0.15, 0.1}, {0.02, 0.1}}};
    const std::vector<int> boxes = {1, 2, kVisible};
    return {
        {"guided_beside_one_set",
         emission,
         true,
         plan_over(top(1), 1024, 1024, 256, 0.3F),
         {1000, 105000},
         0.01,
         0.001,
         guided_over(0.14, 0.3, 512, 0.2, 0.5)},
        {"guided_beside_two_sets",
         emission,
         true,
         plan_over(top(2), 1024, 1024, 128, 0.15F),
         {2500, 360000},
         0.01,
         0.002,
         guided_over(0.17, 0.24, 512, 0.05, 0)},
        {"bounded_weights_few_chains",
         emission,
         true,
         plan_over(top(1), 0, 512, 16, 0.3F),
         {1000, 105000},
         0.01,
         0.001,
         bounded(1024, 0.5)},
        {"bounded_weights_many_chains",
         emission,
         true,
         plan_over(top(1), 0, 512, 256, 0.1F),
         {1000, 105000},
         0.01,
         0.001,
         bounded(1024, 1)},
        {"guided_in_eight_dimensions",
         eight,
         true,
         plan_over(top(1), 512, 512, 256, 0.3F),
         {1000, 105000},
         0.01,
         0.001,
         guided_over(0.1, 0.4, 512, 0.3, 1)},
        {"random_points", two, false, {1000, {}}, {1500, 195000}},
        {"sobol_points", eight, true, {1024, {}}, {500, 66000}},
        {"one_set_copies", eight, true, plan_over(top(1), 512, 512, 256, 0.3F), {1000, 105000}},
        {"one_set_random_points",
         two,
         false,
         plan_over(top(1), 1024, 512, 384, 0.3F),
         {1300, 165000}},
        {"one_set_thousands_of_seeds",
         line,
         true,
         plan_over(top(1), 16384, 8192, 5900, 0.1F),
         {30, 2700}},
        {"two_sets_few_chains",
         line,
         true,
         plan_over(top(2), 1024, 1024, 8, 0.5F),
         {1000, 114000},
         0.01,
         0.0015},
        {"two_sets_many_chains",
         line,
         true,
         plan_over(top(2), 1024, 1024, 512, 0.15F),
         {300, 42000}},
        {"two_sets_many_slots",
         many,
         true,
         plan_over(top(2), 512, 512, 128, 0.3F),
         {300, 18000},
         0.035,
         0.006},
        {"three_sets_few_chains",
         line,
         true,
         plan_over(top(3), 1024, 1024, 8, 0.5F),
         {1000, 180000},
         0.011,
         0.0015},
        {"three_sets_many_chains",
         line,
         true,
         plan_over(top(3), 1024, 1024, 512, 0.15F),
         {350, 57000}},
        {"five_sets_few_chains",
         line,
         true,
         plan_over(top(5), 1024, 1024, 8, 0.5F),
         {600, 36000},
         0.018,
         0.003},
        {"five_sets_many_chains",
         line,
         true,
         plan_over(top(5), 1024, 1024, 512, 0.15F),
         {500, 36000},
         0.015,
         0.002},
        {"holding_times",
         nested,
         true,
         plan_over(boxes, 300, 300, 40, 0.02F),
         {5000, 300000},
         0.04,
         0.008},
        {"few_seeds",
         sticky,
         true,
         plan_over(top(2), 4, 8, 4, 0.003F),
         {100000, 4500000},
         0.015,
         0.004},
        {"seeds_left_out",
         sticky,
         true,
         plan_over(top(2), 16, 32, 2, 0.003F),
         {40000, 3600000},
         0.02,
         0.004},
    };
}

}  // namespace sunfleck::engine::laws
