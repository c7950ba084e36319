// Pilot: learns before any pass how rare visible paths are, which level sets lead to them, and the
// mutation scales.
//
// In:  a path space, a budget. Out: a plan. Pilots are no part of a picture, so what they learn may
// depend on their random numbers in any way.
// Source: rules and constants are measured (docs/develop/decisions.md).
#pragma once

#include "chains/chain_walk.h"
#include "chains/guide_tuning.h"
#include "chains/learned_guide.h"
#include "chains/splitting_rules.h"
#include "guide/guide_source.h"

#include <algorithm>
#include <optional>

namespace sunfleck::engine {

/// Results of a pilot.
struct PilotResult {
    SplittingPlan plan;
    GuidedPlan guided;        // used in addition, where it pays
    HeightTail tail{};        // its last entry is the visible fraction
    SplittingCounts last;     // of the last trial of the plan's levels, if it has several
    std::uint64_t paths = 0;  // traced by iterations, without the guide search
};

template <PathSpace Space, class Points>
class Pilot {
public:
    Pilot(const Space& space, const PilotName& name, GuideSource maps = {},
          Sets sets = Sets::as_needed)
        : space_(space), source_(std::move(maps)), sets_(sets), walk_(space, name) {}

    /// Climbs from uniform paths to visible ones, level set by level set; or starts from guide
    /// samples if that fails or succeeded by luck. It is the first call.
    const HeightTail& explore() {
        climb();
        has_climbed_ = result_.tail[kVisible] > 0;
        if (has_climbed_ && !was_lucky_) return result_.tail;
        if (source_.is_on && source_.walks && start_from_guide_samples()) {
            has_climbed_ = false;
            learn_guide(GuideCoverage::all_known);
            result_.tail[kVisible] = guide_->visible_fraction;
        }
        return result_.tail;
    }

    /// Returns results and the plan for passes of that many paths. It may be called again for other
    /// numbers.
    PilotResult plan(std::uint32_t paths) {
        const HeightTail& tail = result_.tail;
        if (source_.is_on && has_climbed_ && is_rare(tail) && !guide_)
            learn_guide(GuideCoverage::often_visible);
        result_.guided = {};
        result_.last = {};
        if (guide_ && guide_->rest < kMostRest) {
            SharedPlan shared = shared_plan(tail, *guide_, paths, sets_);
            result_.plan = std::move(shared.splitting);
            result_.guided = std::move(shared.guided);
        } else {
            result_.plan = splitting_plan(tail, paths, sets_);
        }
        std::vector<LevelPlan>& levels = result_.plan.levels;
        const bool has_one_set = levels.size() == 1 && result_.guided.paths == 0 && has_climbed_;
        for (LevelPlan& level : levels)
            level.scales = has_one_set ? scales_of_one_set() : scales_near(level.height);
        if (levels.size() > 1) refine();
        result_.paths = walk_.paths();
        return result_;
    }

    /// Calls explore() and plan(). @param paths  per pass of the plan.
    PilotResult run(std::uint32_t paths) {
        explore();
        return plan(paths);
    }

private:
    using Walk = ChainWalk<Space>;

    struct Explored {
        int height;
        MutationScales scales;
    };

    void walk_until_settled(int height, MutationScales& scales, Population& population) {
        counts_ = walk_.until_settled(height, kTargetAcceptance, scales, population, tally_);
        explored_.push_back({height, scales});
        if (height == kVisible) visible_ = population;
    }

    /// Returns scales of the visible set if uniform paths are its survivors.
    const MutationScales& scales_of_one_set() {
        if (!one_set_) {
            one_set_ = scales_near(kVisible);
            walk_.until_settled(kVisible, kTargetOfOneSet, *one_set_, visible_, tally_);
        }
        return *one_set_;
    }

    /// @param weight  of all of them.
    void add_starts(const Population& population, double weight) {
        std::vector<Survivor> survivors = population.survivors();
        resample_emission(space_, survivors, walk_.next_iteration(), tally_);
        for (const Survivor& survivor : survivors)
            starts_.push_back(
                {emission_of(survivor.sample), weight * survivor.total() / population.weight()});
    }

    /// @param seen  flux that importons find of all lights.
    /// @return whether more importons may find what matters: false once there are enough guide
    /// samples, or if light that no importon has reached would be negligible.
    bool walk_for_guide_samples(PassId pass, const PathRange& walks, std::size_t enough,
                                double seen, WalkedEmission& found) const {
        for (std::size_t i = walks.begin; i < walks.end; i += kWalksAtOnce) {
            if (found.guide_samples.size() >= enough) return false;
            const auto so_far = static_cast<double>(i);
            if (i > 0 && found.possible / so_far * kEventsMissed / so_far < kNegligible * seen)
                return false;
            const WalkedEmission more = source_.walks(pass, {i, i + kWalksAtOnce});
            found.guide_samples.insert(found.guide_samples.end(), more.guide_samples.begin(),
                                       more.guide_samples.end());
            found.possible += more.possible;
        }
        return true;
    }

    /// Returns the limit of a long search: no more than the picture is worth.
    std::size_t long_search() const {
        return std::clamp<std::size_t>(source_.most_walks / kWalksAtOnce * kWalksAtOnce, kFewWalks,
                                       kMostWalks);
    }

    /// Finds visible paths of light close to edges. @param tries  number of edge samples.
    Population visible_past_edges(std::size_t tries) {
        const std::vector<WeightedEmission> past =
            source_.edges(walk_.next_iteration(), {0, tries});
        const GuideSampleBudget all{past.size(), kTriesPastEdges};
        return visible_from(space_, past, walk_.next_iteration(), tally_, all);
    }

    /// @return whether any guide sample leads to a visible path.
    bool start_from_guide_samples() {
        const PassId pass = walk_.next_iteration();
        const double seen = source_.seen ? source_.seen(walk_.next_iteration()) : 0;
        WalkedEmission found;
        Population population;
        const bool matters =
            walk_for_guide_samples(pass, {0, kFewWalks}, kManyGuideSamples, seen, found);
        if (found.guide_samples.size() < kFewGuideSamples) {
            if (source_.edges) population = visible_past_edges(matters ? kManyTries : kSomeTries);
            if (matters && !has_climbed_ && population.units() < kFewGuideSamples)
                walk_for_guide_samples(pass, {kFewWalks, long_search()}, kFewGuideSamples, seen,
                                       found);
        }
        population.add(visible_from(space_, found.guide_samples, walk_.next_iteration(), tally_));
        if (population.units() == 0) return false;
        add_starts(population, kStartingIterations);
        if (has_climbed_) add_starts(visible_, 1);
        MutationScales scales;
        walk_until_settled(kVisible, scales, population);
        return true;
    }

    /// Learns a guide from the starts of chains with adapted scales.
    void learn_guide(GuideCoverage covering) {
        MutationScales scales = scales_near(kVisible);
        for (int i = 0; i < kStartingIterations; ++i) {
            walk_.once(kVisible, kTargetAcceptance, scales, visible_, tally_);
            add_starts(visible_, 1);
        }
        const GuideLearner<Space> learner(space_, tally_);
        std::vector<PassId> iterations(covering == GuideCoverage::all_known ? kGuideIterationsAlone
                                                                            : kGuideIterations);
        for (PassId& iteration : iterations) iteration = walk_.next_iteration();
        guide_ = learner.learn(starts_, covering, iterations);
        walk_.add_paths(iterations.size() * kGuideTrials);
    }

    /// Returns the scales of the highest explored level set that is not above `height`.
    MutationScales scales_near(int height) const {
        MutationScales scales;
        for (const Explored& e : explored_)
            if (e.height <= height) scales = e.scales;
        return scales;
    }

    /// Runs small splittings over the plan's own level sets, to adapt their scales.
    void refine() {
        struct Nowhere {
            struct Collector {
                void operator()(const typename Space::Path&, double) {}
            };
            Collector make() { return {}; }
            void take(std::vector<Collector>&&) {}
        } nowhere;
        SplittingPlan small = result_.plan;
        GuidedPlan guided = result_.guided;
        if (guided.paths > 0) guided.paths = kWalkStates / 4;
        small.uniform_paths = 2 * kWalkStates;
        for (LevelPlan& level : small.levels) {
            level.states = kWalkStates;
            level.chains = kWalkChains;
        }
        const int iterations = result_.guided.paths > 0 ? kRefiningRest : kRefiningIterations;
        for (int i = 0; i < iterations; ++i) {
            const PassId pass = walk_.next_iteration();
            const Points points(pass);
            result_.last = Splitting(space_, points, pass, small, guided).run(nowhere, tally_);
            for (std::size_t k = 0; k + 1 < result_.last.levels.size(); ++k)
                small.levels[k].scales =
                    adapted(small.levels[k].scales, result_.last.levels[k + 1].acceptances,
                            kTargetAcceptance);
            walk_.add_paths(small.paths() + guided.paths);
        }
        for (std::size_t k = 0; k < small.levels.size(); ++k)
            result_.plan.levels[k].scales = small.levels[k].scales;
    }

    void climb();

    const Space& space_;
    GuideSource source_;
    Sets sets_;
    typename Space::Tally tally_;
    Walk walk_;
    LevelCounts counts_;  // of the last iteration
    std::vector<Explored> explored_;
    bool has_climbed_ = false;               // reached the visible set
    bool was_lucky_ = false;                 // by few survivors, which may represent little of all
    Population visible_;                     // states of the visible set
    std::vector<WeightedEmission> starts_;   // of visible paths
    std::optional<LearnedGuide> guide_;      // if it was learned
    std::optional<MutationScales> one_set_;  // of the visible set alone
    PilotResult result_;
};

template <PathSpace Space, class Points>
void Pilot<Space, Points>::climb() {
    const PassId pass = walk_.next_iteration();
    UniformLevel uniform = uniform_level(space_, Points(pass), kUniformPaths, 1, tally_);
    counts_ = uniform.counts;
    Population population = std::move(uniform.population);
    walk_.add_paths(kUniformPaths);
    int height = 0;
    double fraction = 1;
    MutationScales scales;
    while (true) {
        const auto states = static_cast<double>(counts_.states);
        for (int h = height; h < kHeights; ++h)
            result_.tail.at(static_cast<std::size_t>(h)) =
                fraction * static_cast<double>(counts_.at_least(h)) / states;
        if (height == kVisible || !is_rare(result_.tail)) return;
        const int next = next_height(counts_.heights, height);
        if (next == kHeights) return;
        if (counts_.at_least(next) <= kLucky) was_lucky_ = true;
        fraction *= static_cast<double>(counts_.at_least(next)) / states;
        height = next;
        population = population.at_least(height);
        walk_until_settled(height, scales, population);
    }
}

}  // namespace sunfleck::engine
