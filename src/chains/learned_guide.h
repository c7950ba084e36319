// GuideLearner: learns an emission guide that covers most visible paths.
//
// In:  approximate starts of visible paths. Out: a guide, and the fraction that it does not cover.
// Trials are no part of a picture, so what is learned may depend on their random numbers in any
// way.
// Source: constants are measured (docs/develop/decisions.md).
#pragma once

#include "chains/guide_tuning.h"
#include "chains/splitting.h"
#include "guide/guided_points.h"

#include <span>

namespace sunfleck::engine {

/// Which boxes a guide covers.
enum class GuideCoverage {
    often_visible,  // boxes in which one path in 20 is visible; chains find the others
    all_known  // every box with more visible paths than uniform sampling finds; chains find none
};

struct LearnedGuide {
    EmissionGuide map;            // the identity if it covers nothing
    double rest = 1;              // estimated fraction of visible paths outside
    double visible_fraction = 0;  // by uniform sampling
    GuideCoverage covering = GuideCoverage::often_visible;
    double visible_share = 0;  // fraction of guided paths that are visible
};

/// Limits of the search for visible paths from guide samples.
struct GuideSampleBudget {
    std::size_t most = kManyGuideSamples;  // evenly selected from all
    int tries = kTriesOfAGuideSample;
};

/// Traces visible paths with the emission of guide samples and other dimensions at random: at most
/// one per guide sample.
template <PathSpace Space>
Population visible_from(const Space& space, const std::vector<WeightedEmission>& guide_samples,
                        PassId pass, typename Space::Tally& tally,
                        const GuideSampleBudget& effort = {}) {
    const std::size_t count = std::min(effort.most, guide_samples.size());
    std::vector<std::vector<Survivor>> found(count);
    std::vector<typename Space::Tally> tallies(count);
    std::vector<RandomStream> streams;
    for (std::size_t i = 0; i < count; ++i) streams.push_back(pass.stream(Purpose::chain, i));
    const auto try_each = [&](std::size_t i, int tries) {
        const EmissionPoint& guide_sample = guide_samples[i * guide_samples.size() / count].point;
        typename Space::Path path;
        for (int k = 0; k < tries && found[i].empty(); ++k) {
            StoredSample sample;
            for (std::uint32_t s = 0; s < kGuidedDimensions; ++s)
                sample.set(s, to_fraction(guide_sample.at(s)));
            space.trace(RepeatingReader(sample, streams[i]), path, tallies[i]);
            if (space.height(path) == kVisible) found[i].push_back({sample, 1, kVisible});
        }
    };
    const int few = std::min(kFewTriesOfAGuideSample, effort.tries);
    parallel_for(count, [&](std::size_t i) { try_each(i, few); });
    const auto failed = std::count_if(found.begin(), found.end(),
                                      [](const auto& survivors) { return survivors.empty(); });
    if (count - static_cast<std::size_t>(failed) < kEnoughVisible)
        parallel_for(count, [&](std::size_t i) { try_each(i, effort.tries - few); });
    Population population;
    for (std::size_t i = 0; i < count; ++i) {
        population.add(std::move(found[i]));
        tally += tallies[i];
    }
    return population;
}

/// Redraws every emission dimension of each survivor in turn, where the path stays visible (Gibbs
/// sampling): dimensions with little effect are then uniform, however chains move them.
template <PathSpace Space>
void resample_emission(const Space& space, std::vector<Survivor>& survivors, PassId pass,
                       typename Space::Tally& tally) {
    std::vector<typename Space::Tally> tallies(survivors.size());
    parallel_for(survivors.size(), [&](std::size_t i) {
        RandomStream stream = pass.stream(Purpose::chain, i);
        typename Space::Path path;
        for (std::uint32_t s = 0; s < kGuidedDimensions; ++s) {
            StoredSample trial = survivors[i].sample;
            trial.set(s, stream.next_fraction());
            space.trace(RepeatingReader(trial, stream), path, tallies[i]);
            if (space.height(path) == kVisible) survivors[i].sample = std::move(trial);
        }
    });
    for (const auto& t : tallies) tally += t;
}

template <PathSpace Space>
class GuideLearner {
public:
    using Tally = typename Space::Tally;

    GuideLearner(const Space& space, Tally& tally) : space_(space), tally_(tally) {}

    /// @param starts  emission of visible paths, weighted.
    /// @param iterations  names of the trials, at least two: all but the last correct the guide,
    /// the last one decides where it is used.
    LearnedGuide learn(const std::vector<WeightedEmission>& starts, GuideCoverage covering,
                       std::span<const PassId> iterations) const {
        // Trials decide which boxes are used, so boxes may be small, and some cuts by chance.
        const double least_gain =
            covering == GuideCoverage::often_visible ? kLeastGain : kLeastGainAlone;
        EmissionGuide map = EmissionGuide::learned(starts, {kUniformAtFirst, least_gain});
        Trials before;
        for (const PassId& iteration : iterations.first(iterations.size() - 1)) {
            before.add(tried(map, iteration));
            map = EmissionGuide::learned(joined(starts, before), {kUniformLater, least_gain});
            if (covering == GuideCoverage::all_known) map = map.widened(kKeptByWidening);
        }
        const Trials last = tried(map, iterations.back());
        if (covering == GuideCoverage::often_visible) map = map.where_visible(last.trials, kOften);
        LearnedGuide learned{map, 1, last.visible / kGuideTrials, covering,
                             visible_share(map, last)};
        if (!learned.map.is_identity()) learned.rest = rest(learned.map, starts, last);
        return learned;
    }

private:
    struct Trials {
        std::vector<EmissionGuide::Trial> trials;
        std::vector<double> weights;  // 1 / density
        double visible = 0;           // sum of weights of visible ones

        void add(const Trials& more) {
            trials.insert(trials.end(), more.trials.begin(), more.trials.end());
            weights.insert(weights.end(), more.weights.begin(), more.weights.end());
            visible += more.visible;
        }
    };

    Trials tried(const EmissionGuide& map, PassId iteration) const {
        const Population all =
            uniform_level(space_, GuidedPoints(iteration, map), kGuideTrials, 0, tally_).population;
        Trials result;
        for (const Survivor& survivor : all.survivors()) {
            const EmissionPoint point = emission_of(survivor.sample);
            const double density = map.density(point);
            if (!(density > 0)) continue;  // rounded into an empty box beside its own
            result.trials.push_back({point, survivor.height == kVisible});
            result.weights.push_back(1 / density);
            if (survivor.height == kVisible) result.visible += result.weights.back();
        }
        return result;
    }

    /// Combines starts and visible trials with equal weight, so that neither dominates.
    static std::vector<WeightedEmission> joined(std::vector<WeightedEmission> starts,
                                                const Trials& trials) {
        double mass = 0;
        for (const WeightedEmission& start : starts) mass += start.weight;
        for (std::size_t i = 0; i < trials.trials.size(); ++i) {
            if (!trials.trials[i].visible) continue;
            const double share = std::min(trials.weights[i] / trials.visible, kMostOfAllStarts);
            starts.push_back({trials.trials[i].point, share * mass});
        }
        return starts;
    }

    /// Returns the visible fraction of trials in the guided region; their densities differ by what
    /// where_visible() changed.
    static double visible_share(const EmissionGuide& map, const Trials& trials) {
        std::size_t covered = 0;
        std::size_t visible = 0;
        for (const EmissionGuide::Trial& trial : trials.trials) {
            if (!map.covers(trial.point)) continue;
            ++covered;
            visible += trial.visible ? 1 : 0;
        }
        return covered == 0 ? 0 : static_cast<double>(visible) / static_cast<double>(covered);
    }

    /// Returns the fraction that is not covered: the mean of estimates by trials, of which few have
    /// large weights, and by starts.
    static double rest(const EmissionGuide& map, const std::vector<WeightedEmission>& starts,
                       const Trials& trials) {
        double of_trials = 0;
        for (std::size_t i = 0; i < trials.trials.size(); ++i)
            if (trials.trials[i].visible && !map.covers(trials.trials[i].point))
                of_trials += trials.weights[i] / trials.visible;
        double mass = 0;
        double of_starts = 0;
        for (const WeightedEmission& start : starts) {
            mass += start.weight;
            if (!map.covers(start.point)) of_starts += start.weight;
        }
        return std::max((of_trials + of_starts / mass) / 2, kLeastRest);
    }

    const Space& space_;
    Tally& tally_;
};

}  // namespace sunfleck::engine
