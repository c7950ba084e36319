// Paths through a map, beside a ladder: they bring light, and seeds of its last set.
//
// In:  a map fixed before the pass. Out: visible paths with weights, the sum of which is an
// estimate of what is visible where the map covers; the same paths as seeds with these weights.
#pragma once

#include "chains/uniform_level.h"
#include "guide/guided_points.h"

#include <algorithm>

namespace sunfleck {

/// Uniform paths through a map, and how the light from where it covers is shared: these paths bring
/// some of it themselves; of the visible ones, as seeds, a ladder's last chains bring the rest.
struct MappedPlan {
    EmissionMap map;
    std::uint32_t paths = 0;  // none: there is no map
    double importance = 1;    // to the chains, of what the map covers, in (0,1]
    double own_share = 1;     // of the light, in [0,1]

    MapCover cover() const { return paths == 0 ? MapCover{} : MapCover{&map, importance}; }
};

/// Keeps what is visible of a block's paths: its share of the light, and a seed.
template <PathSpace Space, class Collector>
struct MappedBlock {
    const MappedPlan& plan;
    Collector& collect;
    std::vector<Seed>& seeds;

    void operator()(const MappedPoints::Reader& reader, const StoredSample& sample,
                    const typename Space::Path& path, int height) const {
        if (height != kVisible) return;
        const double weight = reader.weight() / plan.paths;
        if (plan.own_share > 0) collect(path, weight * plan.own_share);
        seeds.push_back({sample, 1, height, weight * plan.importance});
    }
};

/// @param pass  of the ladder. @param sink  gets visible paths with their share of their weight.
/// @return the visible paths as seeds, with their weights times the importance.
template <PathSpace Space, PathSink<Space> Sink>
UniformLevel mapped_level(const Space& space, PassId pass, const MappedPlan& plan, Sink& sink,
                          typename Space::Tally& tally) {
    using Block = PathBlock<Space>;
    using Collector = typename Sink::Collector;
    const std::size_t at_once = paths_at_once(plan.paths);
    const MappedPoints points(pass, plan.map);
    UniformLevel level;
    for (std::size_t first = 0; first < plan.paths; first += at_once) {
        const std::size_t some = std::min(at_once, plan.paths - first);
        std::vector<Block> blocks(Block::needed(some));
        std::vector<Collector> collectors;
        for (std::size_t i = 0; i < blocks.size(); ++i) collectors.push_back(sink.make());
        parallel_blocks(some, Block::kPaths, [&](std::size_t begin, std::size_t end) {
            Block& block = blocks[begin / Block::kPaths];
            const MappedBlock<Space, Collector> keep{plan, collectors[begin / Block::kPaths],
                                                     block.seeds};
            block.counts =
                trace_range(space, points, {first + begin, first + end}, keep, block.tally);
        });
        level.take(std::move(blocks), tally);
        sink.take(std::move(collectors));
    }
    return level;
}

}  // namespace sunfleck
