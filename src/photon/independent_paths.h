// Uniform photon paths: the samplers `random` and `uniform`.
//
// `random`:  all dimensions are independent (the paper's baseline).
// `uniform`: emission dimensions are Sobol' points with a new shift per pass.
#pragma once

#include "core/parallel.h"
#include "photon/interleaved.h"
#include "random_numbers/emission_points.h"
#include "visible_points/photon_chunk.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace sunfleck::engine {

enum class UniformKind { random, uniform };

struct UniformPaths {
    UniformKind kind = UniformKind::uniform;
    PassId pass;
    std::uint32_t count = 0;
};

/// Returns the number of paths with at least one accepted photon. @param range  of the chunk.
inline std::uint64_t visible_paths(const PhotonChunk& chunk, const PathRange& range) {
    std::vector<std::uint8_t> visible(range.size(), 0);
    for (std::size_t i = 0; i < chunk.paths.size(); ++i)
        visible[chunk.paths[i] - range.begin] |= chunk.taken[i];
    return std::accumulate(visible.begin(), visible.end(), std::uint64_t{0});
}

/// Traces the paths of one chunk.
/// @param may_accept  called with a photon: false if no visible point can accept it.
template <class Points, class MayAccept>
void trace_chunk(const PhotonTracer& tracer, const Points& points, const PathRange& range,
                 const MayAccept& may_accept, PhotonChunk& chunk) {
    const auto visit = [&](const Photon& photon, std::uint32_t number) {
        if (may_accept(photon)) chunk.add(photon, number);
    };
    const auto ended = [&](PathEnd end) { count_end(end, chunk.statistics); };
    chunk.reserve(range.size() + range.size() / 4);
    InterleavedPaths paths(tracer, points, visit, ended);
    chunk.statistics[Count::photon_rays] += paths.trace(range);
    chunk.statistics[Count::uniform_paths] += range.size();
}

/// Paths per chunk.
inline constexpr std::size_t kChunkPaths = 512;

/// Traces the paths of the range in blocks of kChunkPaths, one chunk each.
/// @param may_accept  see trace_chunk().
template <class MayAccept>
std::vector<PhotonChunk> trace_chunks(const PhotonTracer& tracer, const UniformPaths& paths,
                                      const PathRange& range, const MayAccept& may_accept) {
    const EmissionPoints even(paths.pass);
    const IndependentPoints independent(paths.pass);
    std::vector<PhotonChunk> chunks((range.size() + kChunkPaths - 1) / kChunkPaths);
    parallel_blocks(range.size(), kChunkPaths, [&](std::size_t first, std::size_t last) {
        PhotonChunk& chunk = chunks[first / kChunkPaths];
        const PathRange block{range.begin + first, range.begin + last};
        if (paths.kind == UniformKind::uniform)
            trace_chunk(tracer, even, block, may_accept, chunk);
        else
            trace_chunk(tracer, independent, block, may_accept, chunk);
    });
    return chunks;
}

/// Traces all paths of the pass in groups whose photons fit in memory.
/// @param deposit  called with the chunks of many paths; marks accepted photons and adds to the
/// statistics.
/// @return counts of paths, rays, visible paths, ends.
template <class MayAccept, class Deposit>
Statistics trace_uniform_paths(const PhotonTracer& tracer, const UniformPaths& paths,
                               const MayAccept& may_accept, const Deposit& deposit) {
    const std::size_t at_once = paths_at_once(paths.count);
    Statistics total;
    for (std::size_t begin = 0; begin < paths.count; begin += at_once) {
        const PathRange range{begin, std::min<std::size_t>(paths.count, begin + at_once)};
        std::vector<PhotonChunk> chunks = trace_chunks(tracer, paths, range, may_accept);
        total += deposit(chunks);
        for (std::size_t i = 0; i < chunks.size(); ++i) {
            const std::size_t first = begin + i * kChunkPaths;
            total += chunks[i].statistics;
            total[Count::uniform_visible] +=
                visible_paths(chunks[i], {first, std::min(range.end, first + kChunkPaths)});
        }
    }
    return total;
}

}  // namespace sunfleck::engine
