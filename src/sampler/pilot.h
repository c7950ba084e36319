// Learning a ladder before it is used: how rare visible paths are, which sets lead to them, and how
// far mutations should go.
//
// In:  a space of paths, a budget. Out: a plan. Pilots are never part of a picture, so what they
// learn may depend on their own random numbers in any way.
// Source: the rules and constants are measured ones (docs/decisions.md).
#pragma once

#include "sampler/ladder_rules.h"

namespace sunfleck {

/// What a pilot found.
struct PilotResult {
    LadderPlan plan;
    HeightTail tail{};        // its last entry is the visible fraction
    LadderCounts last;        // of the last trial of the plan's levels, if it has several
    std::uint64_t paths = 0;  // traced
};

/// What a pilot's random numbers are named by, but for its rounds.
struct PilotName {
    std::uint64_t seed = 0;
    std::uint32_t epoch = 0;  // below 2^20
    std::uint32_t part = 0;   // see PassId

    /// Streams of a round: passes that no render reaches. @param number  below 512.
    constexpr PassId round(std::uint32_t number) const {
        return {seed, 0x80000000U + epoch * 512 + number, part};
    }
};

template <PathSpace Space, class Points>
class Pilot {
public:
    Pilot(const Space& space, const PilotName& name) : space_(space), name_(name) {}

    /// Climbs from uniform paths to visible ones, set by set: the first thing to ask of a pilot.
    const HeightTail& explore();

    /// What was found, and the plan for passes of that many paths; the last thing to ask.
    PilotResult plan(std::uint32_t paths) {
        result_.plan = ladder_plan(result_.tail, paths);
        for (LevelPlan& level : result_.plan.levels) level.scales = scales_near(level.height);
        if (result_.plan.levels.size() > 1) refine();
        return std::move(result_);
    }

    /// Both. @param paths  of the passes that the plan is for.
    PilotResult run(std::uint32_t paths) {
        explore();
        return plan(paths);
    }

private:
    static constexpr std::uint32_t kUniformPaths = 20'000;
    static constexpr std::uint32_t kStates = 4'000;
    static constexpr std::uint32_t kChains = 64;
    static constexpr int kLeastRounds = 3;
    static constexpr int kMostRounds = 12;
    static constexpr int kRefiningRounds = 3;

    struct Explored {
        int height;
        MutationScales scales;
    };

    static bool is_settled(const MutationScales& before, const MutationScales& now) {
        for (std::size_t kind = 0; kind < kMutationKinds; ++kind) {
            const float change = now.scale.at(kind) / before.scale.at(kind);
            if (change < 0.8F || change > 1.25F) return false;
        }
        return true;
    }

    PassId next_pass() { return name_.round(round_++); }

    /// One round in one set: the population becomes its states, the scales adapt.
    LevelCounts walk(int height, MutationScales& scales, Population& population) {
        const LevelPlan plan{height, kStates, kChains, scales};
        const Level<Space> level(space_, next_pass(), 1, plan, population);
        LevelCounts counts;
        population = surviving_states(level, height, counts, tally_);
        scales = adapted(scales, counts.acceptances);
        result_.paths += kStates;
        return counts;
    }

    /// The scales of the highest explored set that is not above `height`.
    MutationScales scales_near(int height) const {
        MutationScales scales;
        for (const Explored& e : explored_)
            if (e.height <= height) scales = e.scales;
        return scales;
    }

    /// Small ladders over the plan's own sets, for their scales.
    void refine() {
        struct Nowhere {
            struct Collector {
                void operator()(const typename Space::Path&, double) {}
            };
            Collector make() { return {}; }
            void take(std::vector<Collector>&&) {}
        } nowhere;
        LadderPlan small = result_.plan;
        small.uniform_paths = 2 * kStates;
        for (LevelPlan& level : small.levels) {
            level.states = kStates;
            level.chains = kChains;
        }
        for (int i = 0; i < kRefiningRounds; ++i) {
            const PassId pass = next_pass();
            result_.last = run_ladder(space_, Points(pass), pass, small, nowhere, tally_);
            for (std::size_t k = 0; k + 1 < result_.last.levels.size(); ++k)
                small.levels[k].scales =
                    adapted(small.levels[k].scales, result_.last.levels[k + 1].acceptances);
            result_.paths += small.paths();
        }
        for (std::size_t k = 0; k < small.levels.size(); ++k)
            result_.plan.levels[k].scales = small.levels[k].scales;
    }

    const Space& space_;
    PilotName name_;
    std::uint32_t round_ = 0;
    typename Space::Tally tally_;
    std::vector<Explored> explored_;
    PilotResult result_;
};

template <PathSpace Space, class Points>
const HeightTail& Pilot<Space, Points>::explore() {
    const PassId pass = next_pass();
    LevelCounts counts;
    Population population =
        uniform_population(space_, Points(pass), kUniformPaths, 1, counts, tally_);
    result_.paths += kUniformPaths;
    int height = 0;
    double fraction = 1;
    MutationScales scales;
    while (true) {
        const auto states = static_cast<double>(counts.states);
        for (int h = height; h < kHeights; ++h)
            result_.tail.at(static_cast<std::size_t>(h)) =
                fraction * static_cast<double>(counts.at_least(h)) / states;
        if (height == kVisible || !is_rare(result_.tail)) return result_.tail;
        const int next = next_height(counts.heights, height);
        if (next == kHeights) return result_.tail;
        fraction *= static_cast<double>(counts.at_least(next)) / states;
        height = next;
        population = population.at_least(height);
        for (int i = 0; i < kMostRounds; ++i) {
            const MutationScales before = scales;
            counts = walk(height, scales, population);
            if (i + 1 >= kLeastRounds && is_settled(before, scales)) break;
        }
        explored_.push_back({height, scales});
    }
}

}  // namespace sunfleck
