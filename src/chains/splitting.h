// Multilevel splitting by visibility: uniform paths, then chains through nested level sets, the
// last of which is "the path is visible".
//
// Every estimate of a pass is exactly unbiased, however few survivors there are.
// In:  a path space, a plan that was fixed before the pass. Out: visible paths with weights: the
// sum of weight * f(path) has the expectation of f over uniform primary samples, for any f that is
// zero on paths that are not visible.
// Source: the paper's replica exchange, within one pass and nested (docs/method/method.md);
// multilevel splitting: Botev and Kroese 2012; waste-free sequential Monte Carlo: Dau and Chopin
// 2022.
// Equations: docs/method/sampling.md, eqs. (12) and (16).
#pragma once

#include "chains/guided_level.h"

#include <optional>

namespace sunfleck::engine {

struct SplittingPlan {
    std::uint32_t uniform_paths = 0;  // level 0
    std::vector<LevelPlan>
        levels;  // heights ascend, the last is kVisible; empty for uniform paths only

    std::uint64_t paths() const {
        std::uint64_t sum = uniform_paths;
        for (const LevelPlan& level : levels) sum += level.states;
        return sum;
    }
    friend bool operator==(const SplittingPlan&, const SplittingPlan&) = default;
};

/// Counts of one splitting. Level 0 is the uniform paths, with `distinct` equal to `states`.
struct SplittingCounts {
    std::vector<LevelCounts> levels;
    std::vector<std::uint64_t> survivors;  // states of level k in the set of level k + 1
    std::optional<Lineages> lineages;      // of the last set's survivors, once chains have run
    LevelCounts guided;                    // guided paths beside the levels
    double visible_fraction = 0;           // sum of all weights: unbiased

    /// Returns the sum over all levels.
    Acceptance mutations() const {
        Acceptance sum;
        for (const LevelCounts& level : levels) sum += level.mutations();
        return sum;
    }
};

namespace splitting_detail {

/// Keeps the states of a chain that are survivors of the next level.
struct SurvivorCollector {
    int least_height;
    std::vector<Survivor> survivors;

    template <PathSpace Space>
    void operator()(const ChainState<Space>& state) {
        if (state.height >= least_height)
            survivors.push_back({state.sample, state.steps, state.height, 1, state.lineage});
    }
};

/// Passes the states of a chain on with their weights.
template <PathSpace Space, class Collector>
struct WeightedCollector {
    Collector collect;
    double each;         // weight of a step of an even target that brings all light
    double brought = 0;  // sum of the weights

    void operator()(const ChainState<Space>& state) {
        const double weight = each * state.share.light / state.share.importance * state.steps;
        if (!(weight > 0)) return;
        collect(state.path, weight);
        brought += weight;
    }
};

}  // namespace splitting_detail

/// Runs a level before the last. @return its states of at least that height.
template <PathSpace Space>
Population surviving_states(const Level<Space>& level, int least_height, LevelCounts& counts,
                            typename Space::Tally& tally) {
    using splitting_detail::SurvivorCollector;
    Population population;
    level.run(
        [&] {
            return SurvivorCollector{least_height, {}};
        },
        [&](std::vector<SurvivorCollector>&& chains) {
            for (SurvivorCollector& chain : chains) population.add(std::move(chain.survivors));
        },
        counts, tally);
    return population;
}

/// Runs the last level: its states bring light.
/// @param survivors  of the visible set, with weights whose sum estimates the measure of the
/// level's target, not empty.
/// @return the sum of all weights.
template <PathSpace Space, PathSink<Space> Sink>
double run_last_level(const Level<Space>& level, const Population& survivors, Sink& sink,
                      LevelCounts& counts, typename Space::Tally& tally) {
    using Weighted = splitting_detail::WeightedCollector<Space, typename Sink::Collector>;
    const double each = survivors.weight() / static_cast<double>(level.states());
    double brought = 0;
    level.run(
        [&] {
            return Weighted{sink.make(), each};
        },
        [&](std::vector<Weighted>&& chains) {
            std::vector<typename Sink::Collector> inner;
            inner.reserve(chains.size());
            for (Weighted& chain : chains) {
                inner.push_back(std::move(chain.collect));
                brought += chain.brought;
            }
            sink.take(std::move(inner));
        },
        counts, tally);
    return brought;
}

/// All levels of a plan that has any, and guided paths.
template <PathSpace Space, class Points>
class Splitting {
public:
    using Tally = typename Space::Tally;

    /// @param points  random points of the paths of level 0.
    /// @param pass  names the random streams of the chains.
    Splitting(const Space& space, const Points& points, PassId pass, const SplittingPlan& plan,
              const GuidedPlan& guided)
        : space_(space), points_(points), pass_(pass), plan_(plan), guided_(guided) {}

    /// Runs the levels; those after a level without survivors are skipped. If the last set has no
    /// survivor, not even by the guide, the pass is zero ("starved"). @return counts.
    template <PathSink<Space> Sink>
    SplittingCounts run(Sink& sink, Tally& tally) const {
        SplittingCounts counts;
        Population survivors = climbed(counts, tally);
        if (guided_.paths > 0) {
            UniformLevel level = guided_level(space_, pass_, guided_, sink, tally);
            counts.guided = level.counts;
            counts.visible_fraction =
                level.population.weight() / guided_.importance * guided_.own_share;
            level.population.begin_lineages(counts.survivors.front());
            survivors.add(std::move(level.population));
        }
        counts.lineages = survivors.lineages();
        if (survivors.units() == 0) return counts;
        const Level<Space> level(space_, pass_, number(plan_.levels.size() - 1),
                                 plan_.levels.back(), survivors, &guided_);
        counts.visible_fraction +=
            run_last_level(level, survivors, sink, counts.levels.emplace_back(), tally);
        return counts;
    }

private:
    static std::uint32_t number(std::size_t level) { return static_cast<std::uint32_t>(level + 1); }

    /// Runs all levels but the last. @return the survivors of the last set outside the guided
    /// region, with their weights.
    Population climbed(SplittingCounts& counts, Tally& tally) const {
        UniformLevel first =
            uniform_level(space_, points_, plan_.uniform_paths, plan_.levels.front().height, tally);
        counts.levels.push_back(first.counts);
        counts.survivors.push_back(first.population.units());
        double weight = 1.0 / plan_.uniform_paths;  // of one step
        Population population = std::move(first.population);
        population.begin_lineages(0);
        for (std::size_t k = 0; k + 1 < plan_.levels.size(); ++k) {
            counts.levels.emplace_back();
            counts.survivors.push_back(0);
            if (population.units() == 0) continue;
            const Level<Space> level(space_, pass_, number(k), plan_.levels[k], population);
            weight *= population.weight() / static_cast<double>(level.states());
            population =
                surviving_states(level, plan_.levels[k + 1].height, counts.levels.back(), tally);
            counts.survivors.back() = population.units();
        }
        return std::move(population).outside(guided_, weight);
    }

    const Space& space_;
    const Points& points_;
    PassId pass_;
    const SplittingPlan& plan_;
    const GuidedPlan& guided_;
};

}  // namespace sunfleck::engine
