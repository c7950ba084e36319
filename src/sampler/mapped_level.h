// Paths through a map, beside a ladder: they bring light, and seeds of its last set.
//
// In:  a map fixed before the pass. Out: visible paths with weights, the sum of which is an
// estimate of what is visible where the map covers; the same paths as seeds with these weights.
#pragma once

#include "sampler/mapped_points.h"
#include "sampler/uniform_level.h"

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

struct MappedLevel {
    Population population;  // of the visible set, seeds with their weights
    LevelCounts counts;     // `distinct` equals `states`
    double visible = 0;     // sum of weights, of visible paths
};

/// @param pass  of the ladder. @param sink  gets visible paths with their share of their weight.
template <PathSpace Space, PathSink<Space> Sink>
MappedLevel mapped_level(const Space& space, PassId pass, const MappedPlan& plan, Sink& sink,
                         typename Space::Tally& tally) {
    using Collector = typename Sink::Collector;
    constexpr std::size_t kBlock = 512;
    constexpr std::size_t kAtOnce = 256 * kBlock;
    struct Block {
        std::vector<Seed> seeds;
        LevelCounts counts;
        double visible = 0;
        typename Space::Tally tally;
    };
    const MappedPoints points(pass, plan.map);
    MappedLevel level;
    for (std::size_t first = 0; first < plan.paths; first += kAtOnce) {
        const std::size_t some = std::min(kAtOnce, plan.paths - first);
        std::vector<Block> blocks((some + kBlock - 1) / kBlock);
        std::vector<Collector> collectors;
        for (std::size_t i = 0; i < blocks.size(); ++i) collectors.push_back(sink.make());
        parallel_blocks(some, kBlock, [&](std::size_t begin, std::size_t end) {
            Block& block = blocks[begin / kBlock];
            Collector& collect = collectors[begin / kBlock];
            block.counts = trace_range(
                space, points, {first + begin, first + end},
                [&](const MappedPoints::Reader& reader, const StoredSample& sample,
                    const typename Space::Path& path, int height) {
                    if (height != kVisible) return;
                    const double weight = reader.weight() / plan.paths;
                    block.visible += weight;
                    if (plan.own_share > 0) collect(path, weight * plan.own_share);
                    block.seeds.push_back({sample, 1, height, weight * plan.importance});
                },
                block.tally);
        });
        for (Block& block : blocks) {
            level.population.add(std::move(block.seeds));
            level.counts += block.counts;
            level.visible += block.visible;
            tally += block.tally;
        }
        sink.take(std::move(collectors));
    }
    return level;
}

}  // namespace sunfleck
