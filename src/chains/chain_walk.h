// ChainWalk: chains over one level set, by which a pilot adapts mutation scales.
//
// In:  a population of the set, initial scales. Out: the population after some thousand steps, and
// scales with about the target acceptance. They are no substream of a picture (chains/pilot.h).
#pragma once

#include "chains/splitting.h"
#include "chains/splitting_tuning.h"

namespace sunfleck::engine {

/// Names the random streams of a pilot, except for its iterations.
struct PilotName {
    std::uint64_t seed = 0;
    std::uint32_t epoch = 0;      // below 2^20
    std::uint32_t substream = 0;  // see PassId::substream

    /// Returns the streams of an iteration: passes that no render reaches. @param number  below
    /// 512.
    constexpr PassId iteration(std::uint32_t number) const {
        return {seed, 0x80000000U + epoch * 512 + number, substream};
    }
};

/// Iterations of a pilot, with the walks among them.
template <PathSpace Space>
class ChainWalk {
public:
    using Tally = typename Space::Tally;

    /// @param space  must outlive this.
    /// @param guided  the chains' target beside it; must outlive this. Null: the same everywhere.
    ChainWalk(const Space& space, const PilotName& name, const GuidedPlan* guided = nullptr)
        : space_(space), name_(name), guided_(guided) {}

    /// Returns the streams of the next iteration.
    PassId next_iteration() { return name_.iteration(round_++); }

    /// Runs one iteration: its states replace the population, and the scales adapt.
    LevelCounts once(int height, float target, MutationScales& scales, Population& population,
                     Tally& tally) {
        const LevelPlan plan{height, kWalkStates, kWalkChains, scales};
        const Level<Space> level(space_, next_iteration(), 1, plan, population, guided_);
        LevelCounts counts;
        population = surviving_states(level, height, counts, tally);
        scales = adapted(scales, counts.acceptances, target);
        paths_ += kWalkStates;
        return counts;
    }

    /// Iterates until the scales hardly change. @return counts of the last iteration.
    LevelCounts until_settled(int height, float target, MutationScales& scales,
                              Population& population, Tally& tally) {
        for (int i = 1;; ++i) {
            const MutationScales before = scales;
            const LevelCounts counts = once(height, target, scales, population, tally);
            if (i == kMostWalkRounds || (i >= kLeastWalkRounds && is_settled(before, scales)))
                return counts;
        }
    }

    /// Adds paths that the pilot traced in other iterations.
    void add_paths(std::uint64_t paths) { paths_ += paths; }
    /// Returns the number of paths traced in all iterations.
    std::uint64_t paths() const { return paths_; }

private:
    static bool is_settled(const MutationScales& before, const MutationScales& now) {
        for (std::size_t kind = 0; kind < kMutationKinds; ++kind) {
            const float change = now.scale.at(kind) / before.scale.at(kind);
            if (change < 0.8F || change > 1.25F) return false;
        }
        return true;
    }

    const Space& space_;
    PilotName name_;
    const GuidedPlan* guided_;
    std::uint32_t round_ = 0;
    std::uint64_t paths_ = 0;
};

}  // namespace sunfleck::engine
