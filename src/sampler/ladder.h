// The visibility ladder: uniform paths, then chains through nested sets, the last of which is "the
// path is visible". Every estimate of a pass is exactly unbiased, however few seeds there are.
//
// In:  a space of paths, a plan that was fixed before the pass. Out: visible paths with weights:
// the sum of weight * f(path) has the expectation of f over uniform primary samples, for any f
// that vanishes on paths that are not visible.
// Source: the paper's replica exchange made one pass and nested (docs/method.md); waste-free
// sequential Monte Carlo: Dau and Chopin 2022.
#pragma once

#include "sampler/uniform_level.h"

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

/// Uniform paths through a map: what they cover is no part of a ladder.
struct MappedPlan {
    EmissionMap map;
    std::uint32_t paths = 0;  // none: there is no map
    double bridge = 1;        // importance of what the map covers to the ladder's chains

    Bridge as_bridge() const { return paths == 0 ? Bridge{} : Bridge{&map, bridge}; }
};

/// Counts of one ladder. Level 0 is the uniform paths, whose `distinct` equals `states`.
struct LadderCounts {
    std::vector<LevelCounts> levels;
    std::vector<std::uint64_t> survivors;  // states of level k that are in the set of level k + 1
    double visible_fraction = 0;           // sum of the weights handed out: unbiased

    /// Another run of the same plan: counts add up, fractions by their share in the mean.
    void add(const LadderCounts& other, double share) {
        levels.resize(other.levels.size());
        survivors.resize(other.survivors.size());
        for (std::size_t k = 0; k < levels.size(); ++k) levels[k] += other.levels[k];
        for (std::size_t k = 0; k < survivors.size(); ++k) survivors[k] += other.survivors[k];
        visible_fraction += other.visible_fraction * share;
    }
    /// Of all levels.
    Acceptance mutations() const {
        Acceptance sum;
        for (const LevelCounts& level : levels) sum += level.mutations();
        return sum;
    }
};

/// Where a ladder's visible paths go. make(weight) gives a collector for one chain, called as
/// collect(path, weight * steps); take(collectors) gets them in the order of the chains.
template <class S, class Space>
concept PathSink = requires(S& sink, typename S::Collector& collect,
                            const typename Space::Path& path, double weight) {
    { sink.make() } -> std::same_as<typename S::Collector>;
    {collect(path, weight)};
    {sink.take(std::vector<typename S::Collector>())};
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

/// Hands the states of a chain on with their weight.
template <PathSpace Space, class Collector>
struct WeightedCollector {
    Collector collect;
    double weight;

    void operator()(const ChainState<Space>& state) {
        if (!state.is_bridge) collect(state.path, weight * state.steps);
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

/// All levels of a plan that has any. What the bridge covers gets no weight.
template <PathSpace Space, class Points>
class Ladder {
public:
    using Tally = typename Space::Tally;

    /// @param points  of level 0. @param pass  names the streams of the chains.
    Ladder(const Space& space, const Points& points, PassId pass, const LadderPlan& plan,
           const Bridge& bridge = {})
        : space_(space), points_(points), pass_(pass), plan_(plan), bridge_(bridge) {}

    /// @return counts; levels after one without survivors are not run: the pass is zero
    /// ("starved").
    template <PathSink<Space> Sink>
    LadderCounts run(Sink& sink, Tally& tally) const {
        LadderCounts counts;
        UniformLevel first =
            uniform_level(space_, points_, plan_.uniform_paths, plan_.levels.front().height, tally);
        counts.levels.push_back(first.counts);
        counts.survivors.push_back(first.population.units());
        double fraction = first.population.weight() / plan_.uniform_paths;
        Population population = std::move(first.population);
        for (std::size_t k = 0; k + 1 < plan_.levels.size() && population.units() > 0; ++k) {
            const Level<Space> level(space_, pass_, number(k), plan_.levels[k], population);
            Population survivors = surviving_states(level, plan_.levels[k + 1].height,
                                                    counts.levels.emplace_back(), tally);
            counts.survivors.push_back(survivors.units());
            fraction *= survivors.weight() / static_cast<double>(level.states());
            population = std::move(survivors);
        }
        if (population.units() > 0) run_last(population, fraction, sink, counts, tally);
        return counts;
    }

private:
    static std::uint32_t number(std::size_t level) { return static_cast<std::uint32_t>(level + 1); }

    /// @param fraction  of the population's set, as estimated by the levels before.
    template <class Sink>
    void run_last(Population& population, double fraction, Sink& sink, LadderCounts& counts,
                  Tally& tally) const {
        using Weighted = ladder_detail::WeightedCollector<Space, typename Sink::Collector>;
        fraction *= population.weigh(bridge_);
        const Level<Space> level(space_, pass_, number(plan_.levels.size() - 1),
                                 plan_.levels.back(), population, bridge_);
        const double weight = fraction / static_cast<double>(level.states());
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
        counts.visible_fraction = weight * static_cast<double>(counted.states - counted.bridges);
    }

    const Space& space_;
    const Points& points_;
    PassId pass_;
    const LadderPlan& plan_;
    Bridge bridge_;
};

}  // namespace sunfleck
