// Level: one level of multilevel splitting, whose chains start from a population and stay in one
// level set.
//
// In:  a population of the set; numbers of states and chains. Out: every state with its number of
// steps, chain by chain, for collectors; integer counts.
// Source: waste-free sequential Monte Carlo, Dau and Chopin 2022; docs/method/method.md.
// Equations: docs/method/sampling.md, eq. (13).
#pragma once

#include "chains/chain.h"
#include "chains/population.h"
#include "core/parallel.h"
#include "random_numbers/path_range.h"
#include "random_numbers/systematic_resampling.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <vector>

namespace sunfleck::engine {

/// Parameters of a level, fixed before the pass.
struct LevelPlan {
    int height = kVisible;     // of the level set: paths of at least this height
    std::uint32_t states = 0;  // of all chains together, at least `chains`
    std::uint32_t chains = 0;  // exact number, by copies or a subset of the survivors: see Level
    MutationScales scales;

    friend bool operator==(const LevelPlan&, const LevelPlan&) = default;
};

using HeightCounts = std::array<std::uint64_t, kHeights>;

/// Counts of a level, the same for any number of threads.
struct LevelCounts {
    std::uint64_t states = 0;    // with repeats
    std::uint64_t distinct = 0;  // survivors and accepted mutations
    Acceptances acceptances;
    HeightCounts heights{};      // of states, with repeats
    std::uint64_t lighting = 0;  // states that bring light, with repeats
    std::uint64_t distinct_lighting = 0;

    LevelCounts& operator+=(const LevelCounts& other) {
        states += other.states;
        distinct += other.distinct;
        lighting += other.lighting;
        distinct_lighting += other.distinct_lighting;
        for (std::size_t k = 0; k < kMutationKinds; ++k) acceptances[k] += other.acceptances[k];
        for (std::size_t h = 0; h < heights.size(); ++h) heights[h] += other.heights[h];
        return *this;
    }
    /// Returns the sum over both kinds of mutations.
    Acceptance mutations() const {
        Acceptance sum;
        for (const Acceptance& kind : acceptances) sum += kind;
        return sum;
    }
    std::uint64_t at_least(int height) const {
        std::uint64_t sum = 0;
        for (auto h = static_cast<std::size_t>(height); h < heights.size(); ++h) sum += heights[h];
        return sum;
    }
};

/// A state of a chain, for collectors.
template <PathSpace Space>
struct ChainState {
    const StoredSample& sample;
    const typename Space::Path& path;
    int height;
    std::uint32_t steps;        // steps in this state, at least 1
    std::uint32_t lineage = 0;  // of the survivor that the chain started from
    ChainShare share = {};
};

/// Receives the states of one chain in order.
template <class C, class Space>
concept StateCollector = requires(C& collect, const ChainState<Space>& state) {
    collect(state);
};

template <PathSpace Space>
class Level {
public:
    using Tally = typename Space::Tally;

    /// @param number  of the level, 1 to 31: names the streams. @param population  not empty.
    Level(const Space& space, PassId pass, std::uint32_t number, const LevelPlan& plan,
          const Population& population, const GuidedPlan* guided = nullptr)
        : space_(space),
          pass_(pass),
          number_(number),
          plan_(plan),
          population_(population),
          target_{plan.height, guided},
          states_(std::max(plan.states, plan.chains)) {}

    std::uint64_t states() const { return states_; }

    /// Runs all chains.
    /// @param make  makes a collector for one chain.
    /// @param take  receives the collectors of consecutive chains, in order, several at a time.
    template <class Make, class Take>
    void run(const Make& make, const Take& take, LevelCounts& counts, Tally& tally) const {
        using Collector = std::invoke_result_t<Make>;
        static_assert(StateCollector<Collector, Space>);
        const std::uint64_t chains = plan_.chains;
        RandomStream offsets = pass_.stream(Purpose::splitting, number_);
        const double offset = offsets.next();
        const double apart = population_.weight() / static_cast<double>(chains);
        const SystematicResampling length(states_, chains, offsets.next_fraction());
        const std::uint64_t at_once =
            std::max<std::uint64_t>(1, paths_at_once(states_) * chains / states_);
        for (std::uint64_t first = 0; first < chains; first += at_once) {
            const std::size_t some = std::min(at_once, chains - first);
            std::vector<Collector> collectors;
            for (std::size_t i = 0; i < some; ++i) collectors.push_back(make());
            std::vector<LevelCounts> counted(some);
            std::vector<Tally> tallied(some);
            parallel_for(some, [&](std::size_t i) {
                const std::uint64_t j = first + i;
                run_chain({j, (static_cast<double>(j) + offset) * apart, length(j)}, collectors[i],
                          counted[i], tallied[i]);
            });
            for (const LevelCounts& c : counted) counts += c;
            for (const Tally& t : tallied) tally += t;
            take(std::move(collectors));
        }
    }

private:
    struct One {
        std::uint64_t number;
        double survivor;  // its position in the population
        std::uint64_t states;
    };

    template <class Collector>
    void run_chain(const One& one, Collector& collect, LevelCounts& counts, Tally& tally) const {
        const auto name = one.number * 32 + number_;
        const Survivor& start = population_.at(one.survivor);
        Chain<Space> chain(space_, target_, start.sample, pass_.stream(Purpose::chain, name),
                           tally);
        std::uint32_t steps = 1;
        const auto leave = [&] {
            collect(ChainState<Space>{chain.sample(), chain.path(), chain.height(), steps,
                                      start.lineage, chain.share()});
            counts.states += steps;
            ++counts.distinct;
            counts.lighting += chain.share().light > 0 ? steps : 0;
            counts.distinct_lighting += chain.share().light > 0 ? 1 : 0;
            counts.heights[static_cast<std::size_t>(chain.height())] += steps;
        };
        for (std::uint64_t i = 1; i < one.states; ++i) {
            if (chain.propose(plan_.scales, counts.acceptances, tally)) {
                leave();
                chain.accept();
                steps = 1;
            } else {
                ++steps;
            }
        }
        leave();
    }

    const Space& space_;
    PassId pass_;
    std::uint32_t number_;
    const LevelPlan& plan_;
    const Population& population_;
    Target target_;
    std::uint64_t states_;
};

}  // namespace sunfleck::engine
