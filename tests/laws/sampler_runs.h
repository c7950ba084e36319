// Runs of a sampler over a space of known measure and flux.
//
// In:  an example and a pass. Out: the sums that the laws speak of.
#pragma once

#include "chains/guided_remainder.h"
#include "laws/toy_paths.h"
#include "math/statistics.h"
#include "random_numbers/emission_points.h"

#include <bit>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace sunfleck::engine::laws {

using testing_support::Islands;
using testing_support::NestedBoxes;
using testing_support::ToyPath;
using testing_support::ToyTally;
using ToySpace = std::variant<Islands, NestedBoxes>;

struct SamplerExample {
    std::string name;
    ToySpace space;
    bool sobol = true;
    SplittingPlan plan;  // no levels: uniform paths alone
    struct Passes {
        std::uint32_t quick = 0;
        std::uint32_t slow = 0;
    } passes;
    double quick_band = 0.01;  // relative: where the interval of the mean must lie
    double slow_band = 0.001;
    GuidedPlan guided = {};  // paths besides, through a guide; or all, of bounded weight
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
    SplittingCounts counts;
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

/// Guided paths of bounded weight, and the chains that bring what they leave.
template <PathSpace Space>
PassSums run_bounded(const Space& space, PassId pass, const LevelPlan& level,
                     const GuidedPlan& guided) {
    PassSums sums;
    SummingSink sink{sums};
    ToyTally tally;
    const GuidedPoints points(pass, guided.map, guided.most_weight);
    std::vector<SummingSink::Collector> one(1);
    std::vector<std::uint32_t> bounded;
    ToyPath path;
    for (std::uint32_t i = 0; i < guided.paths; ++i) {
        GuidedPoints::Reader reader = points.path(i);
        space.trace(reader, path, tally);
        if (space.height(path) != kVisible) continue;
        one[0](path, reader.weight() / guided.paths);
        if (reader.is_bounded()) bounded.push_back(i);
    }
    sink.take(std::move(one));
    const double guided_weight = sums.weight;
    sums.counts = bring_remainder(space, {pass, guided, level, bounded}, sink, tally);
    sums.visible_fraction = guided_weight + sums.counts.visible_fraction;
    return sums;
}

template <PathSpace Space, class Points>
PassSums run_pass(const Space& space, const Points& points, PassId pass, const SplittingPlan& plan,
                  const GuidedPlan& guided = {}) {
    if (guided.most_weight < kUnbounded)
        return run_bounded(space, pass, plan.levels.back(), guided);
    PassSums sums;
    SummingSink sink{sums};
    ToyTally tally;
    if (!plan.levels.empty()) {
        sums.counts = Splitting(space, points, pass, plan, guided).run(sink, tally);
        sums.visible_fraction = sums.counts.visible_fraction;
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
            const auto run = [&](const auto& points) {
                return run_pass(space, points, pass, example.plan, example.guided);
            };
            return example.sobol ? run(EmissionPoints(pass)) : run(IndependentPoints(pass));
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

}  // namespace sunfleck::engine::laws
