// The visibility ladder: uniform paths, then chains through nested sets, the last of which is "the
// path is visible". Every estimate of a pass is exactly unbiased, however few seeds there are.
//
// In:  a space of paths, a plan that was fixed before the pass. Out: visible paths with weights:
// the sum of weight * f(path) has the expectation of f over uniform primary samples, for any f
// that vanishes on paths that are not visible.
// Source: the paper's replica exchange made one pass and nested (docs/method.md); waste-free
// sequential Monte Carlo: Dau and Chopin 2022.
#pragma once

#include "chains/guided_level.h"

namespace sunfleck {

struct LadderPlan {
    std::uint32_t uniform_paths = 0;  // level 0
    std::vector<LevelPlan> levels;    // heights ascending, the last kVisible; none: uniform only

    std::uint64_t paths() const {
        std::uint64_t sum = uniform_paths;
        for (const LevelPlan& level : levels) sum += level.states;
        return sum;
    }
    friend bool operator==(const LadderPlan&, const LadderPlan&) = default;
};

/// Counts of one ladder. Level 0 is the uniform paths, whose `distinct` equals `states`.
struct LadderCounts {
    std::vector<LevelCounts> levels;
    std::vector<std::uint64_t> survivors;  // states of level k that are in the set of level k + 1
    LevelCounts mapped;                    // paths through a map, beside the levels
    double visible_fraction = 0;           // sum of the weights handed out: unbiased

    /// Another run of the same plan: counts add up, fractions by their share in the mean.
    void add(const LadderCounts& other, double share) {
        levels.resize(std::max(levels.size(), other.levels.size()));  // fewer where it starved
        survivors.resize(std::max(survivors.size(), other.survivors.size()));
        for (std::size_t k = 0; k < other.levels.size(); ++k) levels[k] += other.levels[k];
        for (std::size_t k = 0; k < other.survivors.size(); ++k) survivors[k] += other.survivors[k];
        mapped += other.mapped;
        visible_fraction += other.visible_fraction * share;
    }
    /// Of all levels.
    Acceptance mutations() const {
        Acceptance sum;
        for (const LevelCounts& level : levels) sum += level.mutations();
        return sum;
    }
};

namespace ladder_detail {

/// Keeps the states of a chain that are seeds of the next level.
struct SeedCollector {
    int least_height;
    std::vector<Seed> seeds;

    template <PathSpace Space>
    void operator()(const ChainState<Space>& state) {
        if (state.height >= least_height)
            seeds.push_back({state.sample, state.steps, state.height});
    }
};

/// What a state of the last set weighs for each step it stood.
struct StateWeight {
    double elsewhere = 0;
    double covered = 0;  // where a map covers

    double of(bool is_covered) const { return is_covered ? covered : elsewhere; }
};

/// Hands the states of a chain on with their weight.
template <PathSpace Space, class Collector>
struct WeightedCollector {
    Collector collect;
    StateWeight weight;

    void operator()(const ChainState<Space>& state) {
        const double w = weight.of(state.is_covered);
        if (w > 0) collect(state.path, w * state.steps);
    }
};

}  // namespace ladder_detail

/// Runs a level that is not the last. @return its states of at least that height.
template <PathSpace Space>
Population surviving_states(const Level<Space>& level, int least_height, LevelCounts& counts,
                            typename Space::Tally& tally) {
    using ladder_detail::SeedCollector;
    Population population;
    level.run(
        [&] {
            return SeedCollector{least_height, {}};
        },
        [&](std::vector<SeedCollector>&& chains) {
            for (SeedCollector& chain : chains) population.add(std::move(chain.seeds));
        },
        counts, tally);
    return population;
}

/// All levels of a plan that has any, and what goes through a map besides.
template <PathSpace Space, class Points>
class Ladder {
public:
    using Tally = typename Space::Tally;

    /// @param points  of level 0. @param pass  names the streams of the chains.
    Ladder(const Space& space, const Points& points, PassId pass, const LadderPlan& plan,
           const MappedPlan& mapped)
        : space_(space), points_(points), pass_(pass), plan_(plan), mapped_(mapped) {}

    /// @return counts; levels after one without survivors are not run, and if no seed of the last
    /// set came by the map, either, the pass is zero ("starved").
    template <PathSink<Space> Sink>
    LadderCounts run(Sink& sink, Tally& tally) const {
        LadderCounts counts;
        Population seeds = climbed(counts, tally);
        if (mapped_.paths > 0) {
            UniformLevel level = mapped_level(space_, pass_, mapped_, sink, tally);
            counts.mapped = level.counts;
            counts.visible_fraction =
                level.population.weight() / mapped_.importance * mapped_.own_share;
            seeds.add(std::move(level.population));
        }
        if (seeds.units() > 0) run_last(seeds, sink, counts, tally);
        return counts;
    }

private:
    static std::uint32_t number(std::size_t level) { return static_cast<std::uint32_t>(level + 1); }

    /// All levels but the last. @return seeds of that with their weights, but what a map covers.
    Population climbed(LadderCounts& counts, Tally& tally) const {
        UniformLevel first =
            uniform_level(space_, points_, plan_.uniform_paths, plan_.levels.front().height, tally);
        counts.levels.push_back(first.counts);
        counts.survivors.push_back(first.population.units());
        double weight = 1.0 / plan_.uniform_paths;  // of a unit
        Population population = std::move(first.population);
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
        return std::move(population).uncovered(mapped_.cover(), weight);
    }

    /// @param seeds  of the last set with their weights: their sum is an estimate of its measure.
    template <class Sink>
    void run_last(Population& seeds, Sink& sink, LadderCounts& counts, Tally& tally) const {
        using Weighted = ladder_detail::WeightedCollector<Space, typename Sink::Collector>;
        const Level<Space> level(space_, pass_, number(plan_.levels.size() - 1),
                                 plan_.levels.back(), seeds, mapped_.cover());
        const double each = seeds.weight() / static_cast<double>(level.states());
        const ladder_detail::StateWeight weight{
            each, each * (1 - mapped_.own_share) / mapped_.importance};
        LevelCounts& counted = counts.levels.emplace_back();
        level.run(
            [&] {
                return Weighted{sink.make(), weight};
            },
            [&](std::vector<Weighted>&& chains) {
                std::vector<typename Sink::Collector> inner;
                inner.reserve(chains.size());
                for (Weighted& c : chains) inner.push_back(std::move(c.collect));
                sink.take(std::move(inner));
            },
            counted, tally);
        counts.visible_fraction +=
            weight.elsewhere * static_cast<double>(counted.states - counted.covered) +
            weight.covered * static_cast<double>(counted.covered);
    }

    const Space& space_;
    const Points& points_;
    PassId pass_;
    const LadderPlan& plan_;
    const MappedPlan& mapped_;
};

}  // namespace sunfleck
