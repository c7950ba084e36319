// Photon paths from uniform numbers: the samplers `random` and `uniform`.
//
// `random`:  all slots independent (the paper's baseline).
// `uniform`: emission slots from Sobol' points with a fresh shift each pass.
#pragma once

#include "core/parallel.h"
#include "measurement/photon_batch.h"
#include "photon/tracer.h"
#include "sampler/emission_points.h"

#include <algorithm>
#include <vector>

namespace sunfleck {

enum class UniformKind { random, uniform };

struct UniformPaths {
    UniformKind kind = UniformKind::uniform;
    PassId pass;
    std::uint32_t count = 0;
};

/// Paths begin .. end - 1.
struct PathRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t size() const { return end - begin; }
};

/// Paths of which at least one photon was taken. The photons of a path stand together.
inline std::uint64_t visible_paths(const PhotonBatch& batch) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < batch.paths.size();) {
        bool visible = false;
        const std::uint32_t path = batch.paths[i];
        for (; i < batch.paths.size() && batch.paths[i] == path; ++i)
            visible |= batch.taken[i] != 0;
        count += visible ? 1 : 0;
    }
    return count;
}

/// Traces paths begin .. end - 1 in blocks, each into a batch of its own.
/// @param may_take  called with a position: false where no photon can be wanted.
template <class MayTake>
std::vector<PhotonBatch> trace_batches(const PhotonTracer& tracer, const UniformPaths& paths,
                                       const PathRange& range, const MayTake& may_take) {
    constexpr std::size_t kBlock = 512;
    const EmissionPoints points(paths.pass);
    std::vector<PhotonBatch> batches((range.size() + kBlock - 1) / kBlock);
    parallel_blocks(range.size(), kBlock, [&](std::size_t first, std::size_t last) {
        PhotonBatch& batch = batches[first / kBlock];
        for (std::size_t i = first; i < last; ++i) {
            const auto number = static_cast<std::uint32_t>(range.begin + i);
            const auto visit = [&](const Photon& photon) {
                if (may_take(photon.position)) batch.add(photon, number);
                return true;
            };
            std::uint64_t& rays = batch.statistics[Count::photon_rays];
            const RandomStream numbers = paths.pass.stream(Purpose::uniform_path, number);
            const PathEnd path_end = paths.kind == UniformKind::uniform
                                         ? tracer.trace(points.path(number), visit, rays)
                                         : tracer.trace(IndependentReader(numbers), visit, rays);
            batch.statistics[Count::escaped] += path_end == PathEnd::escaped ? 1 : 0;
            batch.statistics[Count::too_long] += path_end == PathEnd::too_long ? 1 : 0;
        }
        batch.statistics[Count::uniform_paths] += last - first;
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
    constexpr std::size_t kAtOnce = std::size_t{1} << 17U;
    Statistics total;
    for (std::size_t begin = 0; begin < paths.count; begin += kAtOnce) {
        const PathRange range{begin, std::min<std::size_t>(paths.count, begin + kAtOnce)};
        std::vector<PhotonBatch> batches = trace_batches(tracer, paths, range, may_take);
        total += deposit(batches);
        for (const PhotonBatch& batch : batches) {
            total += batch.statistics;
            total[Count::uniform_visible] += visible_paths(batch);
        }
    }
    return total;
}

}  // namespace sunfleck
