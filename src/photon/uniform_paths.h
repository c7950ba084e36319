// Photon paths from uniform numbers: the samplers `random` and `uniform`.
//
// `random`:  all slots independent (the paper's baseline).
// `uniform`: emission slots from Sobol' points with a fresh shift each pass.
#pragma once

#include "core/parallel.h"
#include "photon/interleaved.h"
#include "random_numbers/emission_points.h"
#include "visible_points/photon_chunk.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace sunfleck {

enum class UniformKind { random, uniform };

struct UniformPaths {
    UniformKind kind = UniformKind::uniform;
    PassId pass;
    std::uint32_t count = 0;
};

/// The number of paths of which at least one photon was taken. @param range  of the batch.
inline std::uint64_t visible_paths(const PhotonBatch& batch, const PathRange& range) {
    std::vector<std::uint8_t> visible(range.size(), 0);
    for (std::size_t i = 0; i < batch.paths.size(); ++i)
        visible[batch.paths[i] - range.begin] |= batch.taken[i];
    return std::accumulate(visible.begin(), visible.end(), std::uint64_t{0});
}

/// Traces the paths of one batch.
/// @param may_take  called with a photon: false where it cannot be wanted.
template <class Points, class MayTake>
void trace_batch(const PhotonTracer& tracer, const Points& points, const PathRange& range,
                 const MayTake& may_take, PhotonBatch& batch) {
    const auto visit = [&](const Photon& photon, std::uint32_t number) {
        if (may_take(photon)) batch.add(photon, number);
    };
    const auto ended = [&](PathEnd end) { count_end(end, batch.statistics); };
    batch.reserve(range.size() + range.size() / 4);
    InterleavedPaths paths(tracer, points, visit, ended);
    batch.statistics[Count::photon_rays] += paths.trace(range);
    batch.statistics[Count::uniform_paths] += range.size();
}

/// Paths of one batch.
inline constexpr std::size_t kBatchPaths = 512;

/// Traces the paths of the range in blocks of kBatchPaths, each into a batch of its own.
/// @param may_take  see trace_batch().
template <class MayTake>
std::vector<PhotonBatch> trace_batches(const PhotonTracer& tracer, const UniformPaths& paths,
                                       const PathRange& range, const MayTake& may_take) {
    const EmissionPoints even(paths.pass);
    const IndependentPoints independent(paths.pass);
    std::vector<PhotonBatch> batches((range.size() + kBatchPaths - 1) / kBatchPaths);
    parallel_blocks(range.size(), kBatchPaths, [&](std::size_t first, std::size_t last) {
        PhotonBatch& batch = batches[first / kBatchPaths];
        const PathRange block{range.begin + first, range.begin + last};
        if (paths.kind == UniformKind::uniform)
            trace_batch(tracer, even, block, may_take, batch);
        else
            trace_batch(tracer, independent, block, may_take, batch);
    });
    return batches;
}

/// Traces all paths of the pass, some at a time so that their photons fit in memory.
/// @param deposit  called with the batches of many paths; marks the photons that were taken and
///                 counts in their statistics.
/// @return counts: paths, rays, visible paths, ends.
template <class MayTake, class Deposit>
Statistics trace_uniform_paths(const PhotonTracer& tracer, const UniformPaths& paths,
                               const MayTake& may_take, const Deposit& deposit) {
    const std::size_t at_once = paths_at_once(paths.count);
    Statistics total;
    for (std::size_t begin = 0; begin < paths.count; begin += at_once) {
        const PathRange range{begin, std::min<std::size_t>(paths.count, begin + at_once)};
        std::vector<PhotonBatch> batches = trace_batches(tracer, paths, range, may_take);
        total += deposit(batches);
        for (std::size_t i = 0; i < batches.size(); ++i) {
            const std::size_t first = begin + i * kBatchPaths;
            total += batches[i].statistics;
            total[Count::uniform_visible] +=
                visible_paths(batches[i], {first, std::min(range.end, first + kBatchPaths)});
        }
    }
    return total;
}

}  // namespace sunfleck
