// Guided paths beside splitting: they contribute light, and survivors of the last level set.
//
// In:  a guide fixed before the pass. Out: visible paths with weights whose sum estimates the
// visible measure of the guided region; the same paths as survivors with these weights.
// Equations: docs/method/sampling.md, eq. (16).
#pragma once

#include "chains/uniform_level.h"
#include "guide/guided_points.h"

#include <algorithm>

namespace sunfleck::engine {

/// Keeps visible paths of a block: contribution and survivor.
template <PathSpace Space, class Collector>
struct GuidedBlock {
    const GuidedPlan& plan;
    Collector& collect;
    std::vector<Survivor>& survivors;

    void operator()(const GuidedPoints::Reader& reader, const StoredSample& sample,
                    const typename Space::Path& path, int height) const {
        if (height != kVisible) return;
        const double weight = reader.weight() / plan.paths;
        if (plan.own_share > 0) collect(path, weight * plan.own_share);
        survivors.push_back({sample, 1, height, weight * plan.importance});
    }
};

/// @param pass  the pass of the splitting.
/// @param sink  receives visible paths with their fraction of the weight.
/// @return the visible paths as survivors, with weights times the importance.
template <PathSpace Space, PathSink<Space> Sink>
UniformLevel guided_level(const Space& space, PassId pass, const GuidedPlan& plan, Sink& sink,
                          typename Space::Tally& tally) {
    using Block = PathBlock<Space>;
    using Collector = typename Sink::Collector;
    const std::size_t at_once = paths_at_once(plan.paths);
    const GuidedPoints points(pass, plan.map);
    UniformLevel level;
    for (std::size_t first = 0; first < plan.paths; first += at_once) {
        const std::size_t some = std::min(at_once, plan.paths - first);
        std::vector<Block> blocks(Block::needed(some));
        std::vector<Collector> collectors;
        for (std::size_t i = 0; i < blocks.size(); ++i) collectors.push_back(sink.make());
        parallel_blocks(some, Block::kPaths, [&](std::size_t begin, std::size_t end) {
            Block& block = blocks[begin / Block::kPaths];
            const GuidedBlock<Space, Collector> keep{plan, collectors[begin / Block::kPaths],
                                                     block.survivors};
            block.counts =
                trace_range(space, points, {first + begin, first + end}, keep, block.tally);
        });
        level.take(std::move(blocks), tally);
        sink.take(std::move(collectors));
    }
    return level;
}

}  // namespace sunfleck::engine
