// Independent photon paths, without Markov chains: of uniform points, or of a guide's.
//
// In:  points: primary samples by number, with weights if they are not uniform. Out: chunks of
// photons whose flux has the weight of their path.
#pragma once

#include "core/parallel.h"
#include "photon/interleaved.h"
#include "visible_points/photon_chunk.h"

#include <algorithm>
#include <concepts>
#include <type_traits>
#include <vector>

namespace sunfleck::engine {

/// A primary sample that is not uniform: weight() is one over its density, or a bound.
template <class Reader>
concept WeightedReader = requires(const Reader& reader) {
    { reader.weight() } -> std::same_as<double>;
    { reader.is_bounded() } -> std::same_as<bool>;
};

/// Result of a pass.
struct TracedPaths {
    Statistics statistics;               // rays, ends and deposits
    std::uint64_t visible = 0;           // paths with an accepted photon
    double visible_weight = 0;           // sum of the weights of these
    std::vector<std::uint32_t> bounded;  // numbers of those whose weight was bounded
};

/// Traces the paths of one chunk.
/// @tparam Points  path(number) returns a primary-sample reader.
/// @param may_accept  called with a photon: false if no visible point can accept it.
template <class Points, class MayAccept>
void trace_chunk(const PhotonTracer& tracer, const Points& points, const PathRange& range,
                 const MayAccept& may_accept, PhotonChunk& chunk) {
    const auto visit = [&](const Photon& photon, std::uint32_t number, const auto& reader) {
        if (!may_accept(photon)) return;
        chunk.add(photon, number);
        if constexpr (WeightedReader<std::decay_t<decltype(reader)>>)
            chunk.photons.back().flux *= static_cast<float>(reader.weight());
    };
    const auto ended = [&](PathEnd end) { count_end(end, chunk.statistics); };
    chunk.reserve(range.size() + range.size() / 4);
    InterleavedPaths paths(tracer, points, visit, ended);
    chunk.statistics[Count::photon_rays] += paths.trace(range);
}

/// Paths per chunk.
inline constexpr std::size_t kChunkPaths = 512;

/// Traces the paths of the range in blocks of kChunkPaths, one chunk each.
/// @param may_accept  see trace_chunk().
template <class Points, class MayAccept>
std::vector<PhotonChunk> trace_chunks(const PhotonTracer& tracer, const Points& points,
                                      const PathRange& range, const MayAccept& may_accept) {
    std::vector<PhotonChunk> chunks((range.size() + kChunkPaths - 1) / kChunkPaths);
    parallel_blocks(range.size(), kChunkPaths, [&](std::size_t first, std::size_t last) {
        trace_chunk(tracer, points, {range.begin + first, range.begin + last}, may_accept,
                    chunks[first / kChunkPaths]);
    });
    return chunks;
}

/// Adds the paths of a chunk that have an accepted photon. @param range  of the chunk.
template <class Points>
void count_visible(const PhotonChunk& chunk, const PathRange& range, const Points& points,
                   TracedPaths& traced) {
    std::vector<std::uint8_t> visible(range.size(), 0);
    for (std::size_t i = 0; i < chunk.paths.size(); ++i)
        visible[chunk.paths[i] - range.begin] |= chunk.taken[i];
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (visible[i] == 0) continue;
        ++traced.visible;
        if constexpr (WeightedReader<decltype(points.path(0))>) {
            const auto number = static_cast<std::uint32_t>(range.begin + i);
            const auto reader = points.path(number);
            traced.visible_weight += reader.weight();
            if (reader.is_bounded()) traced.bounded.push_back(number);
        } else {
            traced.visible_weight += 1;
        }
    }
}

/// Traces paths 0 .. count - 1 in groups whose photons fit in memory.
/// @param deposit  called with the chunks of many paths; marks accepted photons and returns
/// statistics.
template <class Points, class MayAccept, class Deposit>
TracedPaths trace_independent_paths(const PhotonTracer& tracer, const Points& points,
                                    std::uint32_t count, const MayAccept& may_accept,
                                    const Deposit& deposit) {
    const std::size_t at_once = paths_at_once(count);
    TracedPaths traced;
    for (std::size_t begin = 0; begin < count; begin += at_once) {
        const PathRange range{begin, std::min<std::size_t>(count, begin + at_once)};
        std::vector<PhotonChunk> chunks = trace_chunks(tracer, points, range, may_accept);
        traced.statistics += deposit(chunks);
        for (std::size_t i = 0; i < chunks.size(); ++i) {
            const std::size_t first = begin + i * kChunkPaths;
            traced.statistics += chunks[i].statistics;
            count_visible(chunks[i], {first, std::min(range.end, first + kChunkPaths)}, points,
                          traced);
        }
    }
    return traced;
}

}  // namespace sunfleck::engine
