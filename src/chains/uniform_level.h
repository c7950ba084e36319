// Level 0 of splitting: uniform paths of a pass, of which high ones are kept as survivors.
#pragma once

#include "chains/level.h"
#include "random_numbers/path_range.h"

namespace sunfleck::engine {

/// Consecutive paths, traced by one thread.
template <PathSpace Space>
struct PathBlock {
    static constexpr std::size_t kPaths = 512;
    /// Returns the number of blocks for so many paths.
    static constexpr std::size_t needed(std::size_t paths) { return (paths + kPaths - 1) / kPaths; }

    std::vector<Survivor> survivors;
    LevelCounts counts;
    typename Space::Tally tally;
};

struct UniformLevel {
    Population population;
    LevelCounts counts;  // `distinct` equals `states`

    /// Appends blocks in order.
    template <PathSpace Space>
    void take(std::vector<PathBlock<Space>>&& blocks, typename Space::Tally& tally) {
        for (PathBlock<Space>& block : blocks) {
            population.add(std::move(block.survivors));
            counts += block.counts;
            tally += block.tally;
        }
    }
};

/// Traces a range of paths. @param keep  called as keep(reader, sample, path, height).
template <PathSpace Space, class Points, class Keep>
LevelCounts trace_range(const Space& space, const Points& points, const PathRange& range,
                        const Keep& keep, typename Space::Tally& tally) {
    LevelCounts counts;
    typename Space::Path path;
    StoredSample sample;
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const auto reader = points.path(static_cast<std::uint32_t>(i));
        sample.clear();
        space.trace(RecordingReader(reader, sample), path, tally);
        const int height = space.height(path);
        ++counts.heights[static_cast<std::size_t>(height)];
        keep(reader, sample, path, height);
    }
    counts.states = counts.distinct = range.size();
    return counts;
}

/// Traces paths 0 .. count - 1. @param keep  called as keep(survivors, reader, sample, path,
/// height) to append those that survive.
template <PathSpace Space, class Points, class Keep>
UniformLevel traced_level(const Space& space, const Points& points, std::size_t count,
                          const Keep& keep, typename Space::Tally& tally) {
    using Block = PathBlock<Space>;
    std::vector<Block> blocks(Block::needed(count));
    parallel_blocks(count, Block::kPaths, [&](std::size_t begin, std::size_t end) {
        Block& block = blocks[begin / Block::kPaths];
        block.counts = trace_range(
            space, points, {begin, end},
            [&](const auto& reader, const StoredSample& sample, const typename Space::Path& path,
                int height) { keep(block.survivors, reader, sample, path, height); },
            block.tally);
    });
    UniformLevel level;
    level.take(std::move(blocks), tally);
    return level;
}

/// @tparam Points  path(number) -> a primary-sample reader, uniform in its marginal distribution.
/// @param least_height  of the paths that are kept.
template <PathSpace Space, class Points>
UniformLevel uniform_level(const Space& space, const Points& points, std::uint32_t count,
                           int least_height, typename Space::Tally& tally) {
    return traced_level(
        space, points, count,
        [&](std::vector<Survivor>& survivors, const auto&, const StoredSample& sample,
            const typename Space::Path&, int height) {
            if (height >= least_height) survivors.push_back({sample, 1, height});
        },
        tally);
}

}  // namespace sunfleck::engine
