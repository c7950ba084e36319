// Chains for what guided paths of bounded weight leave.
//
// A path that starts where the guide's density q is low would weigh 1/q, and be a spot in the
// picture. It weighs w at most; chains over the visible set bring the other 1 - w q of its light,
// with that as their target density, so that all of their states weigh the same.
// In:  the guided paths of a pass that are visible and whose weight was bounded. Out: visible paths
// with weights: together with the guided ones they are unbiased like those of splitting.
// Equations: docs/method/sampling.md, eq. (42).
#pragma once

#include "chains/splitting.h"
#include "guide/guided_points.h"

#include <cstdint>
#include <span>

namespace sunfleck::engine {

/// What guided paths of a pass leave.
struct GuidedRemainder {
    PassId pass;
    const GuidedPlan& guided;                // with a most weight
    const LevelPlan& level;                  // of the visible set
    std::span<const std::uint32_t> bounded;  // numbers of visible paths whose weight was bounded
};

/// Some guided points.
struct ChosenPoints {
    const GuidedPoints& points;
    std::span<const std::uint32_t> numbers;

    GuidedPoints::Reader path(std::uint32_t i) const { return points.path(numbers[i]); }
};

/// Traces the bounded paths again.
/// @return them as survivors, with weights whose sum estimates the measure of the chains' target.
template <PathSpace Space>
Population bounded_paths(const Space& space, const GuidedRemainder& rest,
                         typename Space::Tally& tally) {
    const GuidedPlan& guided = rest.guided;
    const GuidedPoints points(rest.pass, guided.map, guided.most_weight);
    const auto keep = [&](std::vector<Survivor>& survivors, const GuidedPoints::Reader& reader,
                          const StoredSample& sample, const typename Space::Path&, int height) {
        const double weight =
            reader.unbounded_weight() / guided.paths * guided.for_chains(sample).importance;
        if (height == kVisible && weight > 0) survivors.push_back({sample, 1, height, weight});
    };
    return traced_level(space, ChosenPoints{points, rest.bounded}, rest.bounded.size(), keep, tally)
        .population;
}

/// Runs chains from the bounded paths. @return counts: level 0 is empty.
template <PathSpace Space, PathSink<Space> Sink>
SplittingCounts bring_remainder(const Space& space, const GuidedRemainder& rest, Sink& sink,
                                typename Space::Tally& tally) {
    Population survivors = bounded_paths(space, rest, tally);
    survivors.begin_lineages(0);
    SplittingCounts counts{{{}}, {survivors.units()}, survivors.lineages(), {}, 0};
    if (survivors.units() == 0) return counts;
    const Level<Space> level(space, rest.pass, 1, rest.level, survivors, &rest.guided);
    counts.visible_fraction =
        run_last_level(level, survivors, sink, counts.levels.emplace_back(), tally);
    return counts;
}

}  // namespace sunfleck::engine
