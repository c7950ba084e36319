// Examples of every sampler, which the laws of tests/laws/sampler_laws_*test.cpp run over.
//
// In:  an example and a pass. Out: the sums that the laws speak of.
#pragma once

#include "laws/toy_paths.h"
#include "math/statistics.h"
#include "sampler/emission_points.h"
#include "sampler/ladder.h"

#include <bit>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace sunfleck::laws {

using testing_support::first_slots;
using testing_support::Islands;
using testing_support::NestedBoxes;
using testing_support::ToyPath;
using testing_support::ToyTally;
using ToySpace = std::variant<Islands, NestedBoxes>;

struct SamplerExample {
    std::string name;
    ToySpace space;
    bool sobol = true;
    LadderPlan plan;  // no levels: uniform paths alone
    struct Passes {
        std::uint32_t quick = 0;
        std::uint32_t slow = 0;
    } passes;
    double quick_band = 0.01;  // relative: where the interval of the mean must lie
    double slow_band = 0.001;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
inline void PrintTo(const SamplerExample& example, std::ostream* out) {
    *out << example.name;
}

/// What a pass gave.
struct PassSums {
    double flux = 0;              // sum of weight * flux: an estimate of E f
    double weight = 0;            // sum of weights
    double visible_fraction = 0;  // an estimate of E V
    std::uint64_t bytes = 0;      // a hash of every flux and weight, in order
    LadderCounts counts;
};

/// A sink that sums, and hashes what it is given, chain by chain.
struct SummingSink {
    struct Collector {
        double flux = 0;
        double weight = 0;
        std::uint64_t bytes = 0xCBF29CE484222325;

        void operator()(const ToyPath& path, double path_weight) {
            flux += path_weight * path.flux;
            weight += path_weight;
            mix(std::bit_cast<std::uint64_t>(path.flux));
            mix(std::bit_cast<std::uint64_t>(path_weight));
        }
        void mix(std::uint64_t word) { bytes = std::rotl(bytes ^ word, 29) * 0x100000001B3; }
    };

    PassSums& sums;
    Collector all = {};

    Collector make() { return {}; }
    void take(std::vector<Collector>&& chains) {
        for (const Collector& chain : chains) {
            sums.flux += chain.flux;
            sums.weight += chain.weight;
            all.mix(chain.bytes);
        }
        sums.bytes = all.bytes;
    }
};

template <PathSpace Space, class Points>
PassSums run_pass(const Space& space, const Points& points, PassId pass, const LadderPlan& plan) {
    PassSums sums;
    SummingSink sink{sums};
    ToyTally tally;
    if (!plan.levels.empty()) {
        sums.counts = run_ladder(space, points, pass, plan, sink, tally);
        sums.visible_fraction = visible_fraction(plan, sums.counts);
        return sums;
    }
    std::vector<SummingSink::Collector> one(1);
    ToyPath path;
    for (std::uint32_t i = 0; i < plan.uniform_paths; ++i) {
        space.trace(points.path(i), path, tally);
        if (space.height(path) == kVisible) one[0](path, 1.0 / plan.uniform_paths);
    }
    sink.take(std::move(one));
    sums.visible_fraction = sums.weight;
    return sums;
}

inline PassSums run_pass(const SamplerExample& example, PassId pass) {
    return std::visit(
        [&](const auto& space) {
            return example.sobol ? run_pass(space, EmissionPoints(pass), pass, example.plan)
                                 : run_pass(space, IndependentPoints(pass), pass, example.plan);
        },
        example.space);
}

/// Estimates over the truth: their expectation is one.
struct Ratios {
    RunningMean flux;
    RunningMean visible_fraction;

    void add(const Ratios& other) {
        flux.add(other.flux);
        visible_fraction.add(other.visible_fraction);
    }
};

/// Passes 0 .. passes - 1 of a seed.
inline Ratios run_passes(const SamplerExample& example, std::uint64_t seed, std::uint32_t passes) {
    constexpr std::uint32_t kBlock = 32;
    const double flux = std::visit([](const auto& s) { return s.mean_flux(); }, example.space);
    const double visible =
        std::visit([](const auto& s) { return s.visible_fraction(); }, example.space);
    std::vector<Ratios> blocks((passes + kBlock - 1) / kBlock);
    parallel_blocks(passes, kBlock, [&](std::size_t begin, std::size_t end) {
        Ratios& block = blocks[begin / kBlock];
        for (std::size_t p = begin; p < end; ++p) {
            const PassSums sums = run_pass(example, {seed, static_cast<std::uint32_t>(p)});
            block.flux.add(sums.flux / flux);
            block.visible_fraction.add(sums.visible_fraction / visible);
        }
    });
    Ratios all;
    for (const Ratios& block : blocks) all.add(block);
    return all;
}

/// A ladder over nested sets of these heights.
/// @param scale  of mutations, both kinds.
inline LadderPlan plan_over(const std::vector<int>& heights, std::uint32_t uniform,
                            std::uint32_t states, std::uint32_t chains, float scale) {
    LadderPlan plan{uniform, {}};
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

/// Passes are as many as the bands of the laws need.
inline std::vector<SamplerExample> sampler_examples() {
    const Islands two{"two", {0, 6}, {{0.25, 0.2, 0.5, 1}, {0.7, 0.18, 0.5, 2}}};
    const Islands eight{"eight", first_slots(8), {{0.3, 0.2, 0.49, 1}, {0.8, 0.19, 0.49, 2}}};
    Islands line{"line", {0, 6}, {{0.2, 0.09, 0.5, 1}, {0.7, 0.07, 0.5, 2}}, 1};
    line.growth = 1.2;
    Islands many{"many", first_slots(64), {{0.2, 0.1, 0.499, 1}, {0.7, 0.07, 0.499, 2}}, 1};
    many.growth = 1.4;
    const Islands sticky{"sticky", first_slots(3), {{0.2, 0.1, 0.5, 1}, {0.7, 0.004, 0.5, 2}}, 1};
    const NestedBoxes nested{"nested", {{0.3, 0.3}, {0.15, 0.1}, {0.02, 0.1}}};
    const std::vector<int> boxes = {1, 2, kVisible};
    return {
        {"random_points", two, false, {1000, {}}, {1500, 65000}},
        {"sobol_points", eight, true, {1024, {}}, {500, 22000}},
        {"one_set_copies", eight, true, plan_over(top(1), 512, 512, 256, 0.3F), {1000, 35000}},
        {"one_set_random_points",
         two,
         false,
         plan_over(top(1), 1024, 512, 384, 0.3F),
         {1300, 55000}},
        {"one_set_thousands_of_seeds",
         line,
         true,
         plan_over(top(1), 16384, 8192, 5900, 0.1F),
         {30, 900}},
        {"two_sets_few_chains",
         line,
         true,
         plan_over(top(2), 1024, 1024, 8, 0.5F),
         {1000, 38000},
         0.01,
         0.0015},
        {"two_sets_many_chains",
         line,
         true,
         plan_over(top(2), 1024, 1024, 512, 0.15F),
         {300, 14000}},
        {"two_sets_many_slots",
         many,
         true,
         plan_over(top(2), 512, 512, 128, 0.3F),
         {150, 6000},
         0.035,
         0.006},
        {"three_sets_few_chains",
         line,
         true,
         plan_over(top(3), 1024, 1024, 8, 0.5F),
         {1000, 30000},
         0.011,
         0.0015},
        {"three_sets_many_chains",
         line,
         true,
         plan_over(top(3), 1024, 1024, 512, 0.15F),
         {350, 19000}},
        {"five_sets_few_chains",
         line,
         true,
         plan_over(top(5), 1024, 1024, 8, 0.5F),
         {600, 12000},
         0.018,
         0.003},
        {"five_sets_many_chains",
         line,
         true,
         plan_over(top(5), 1024, 1024, 512, 0.15F),
         {250, 12000},
         0.015,
         0.002},
        {"holding_times",
         nested,
         true,
         plan_over(boxes, 300, 300, 40, 0.02F),
         {5000, 100000},
         0.04,
         0.008},
        {"few_seeds",
         sticky,
         true,
         plan_over(top(2), 4, 8, 4, 0.003F),
         {100000, 1500000},
         0.015,
         0.004},
        {"seeds_left_out",
         sticky,
         true,
         plan_over(top(2), 16, 32, 2, 0.003F),
         {40000, 600000},
         0.02,
         0.004},
    };
}

}  // namespace sunfleck::laws
