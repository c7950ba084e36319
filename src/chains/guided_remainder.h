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

/// Traces guided paths again. @param plan  with a most weight.
/// @param numbers  of the visible paths whose weight was bounded.
/// @return them as survivors, with weights whose sum estimates the measure of the chains' target.
template <PathSpace Space>
Population bounded_paths(const Space& space, PassId pass, const GuidedPlan& plan,
                         std::span<const std::uint32_t> numbers, typename Space::Tally& tally) {
    const GuidedPoints points(pass, plan.map, plan.most_weight);
    constexpr std::size_t kBlock = 64;
    std::vector<Survivor> survivors(numbers.size());
    std::vector<typename Space::Tally> tallies((numbers.size() + kBlock - 1) / kBlock);
    parallel_blocks(numbers.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        typename Space::Path path;
        for (std::size_t i = begin; i < end; ++i) {
            const GuidedPoints::Reader reader = points.path(numbers[i]);
            Survivor& survivor = survivors[i];
            space.trace(RecordingReader(reader, survivor.sample), path, tallies[begin / kBlock]);
            survivor.height = space.height(path);
            survivor.weight = reader.unbounded_weight() / plan.paths *
                              plan.for_chains(survivor.sample).importance;
        }
    });
    for (const auto& some : tallies) tally += some;
    Population population;
    for (Survivor& survivor : survivors)
        if (survivor.height == kVisible && survivor.weight > 0) population.add(std::move(survivor));
    return population;
}

/// Runs chains from these paths. @param level  of the visible set. @param numbers  see
/// bounded_paths(). @return counts: level 0 is empty.
template <PathSpace Space, PathSink<Space> Sink>
SplittingCounts bring_remainder(const Space& space, PassId pass, const GuidedPlan& plan,
                                const LevelPlan& level, std::span<const std::uint32_t> numbers,
                                Sink& sink, typename Space::Tally& tally) {
    const Population survivors = bounded_paths(space, pass, plan, numbers, tally);
    SplittingCounts counts{{{}}, {survivors.units()}, {}, 0};
    if (survivors.units() == 0) return counts;
    counts.visible_fraction = run_last_level(Level<Space>(space, pass, 1, level, survivors, &plan),
                                             survivors, sink, counts.levels.emplace_back(), tally);
    return counts;
}

}  // namespace sunfleck::engine
