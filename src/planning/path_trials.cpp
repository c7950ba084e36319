// Trials are traced like the paths of a pass, and gathered photon by photon.
#include "planning/path_trials.h"

#include "estimate/photon_terms.h"
#include "guide/guided_points.h"
#include "photon/independent_paths.h"
#include "visible_points/lookup.h"

#include <algorithm>
#include <tuple>

namespace sunfleck::engine {
namespace {

/// Gathers the photons of some paths.
class TrialGatherer {
public:
    TrialGatherer(const PhotonContext& context, const BlockGrid& blocks,
                  const std::vector<PhotonChunk>& chunks)
        : context_(context),
          blocks_(blocks),
          chunks_(chunks),
          photons_(chunks, context.index.grid()) {}

    /// @return one entry per photon and visible point that accepts it, in an order that does not
    /// depend on threads.
    std::vector<PathLight> gather() const {
        constexpr std::size_t kBlocks = 256;
        const std::size_t count = context_.index.block_count();
        std::vector<std::vector<PathLight>> lists((count + kBlocks - 1) / kBlocks);
        parallel_blocks(count, kBlocks, [&](std::size_t begin, std::size_t end) {
            TakenPhotons taken;
            for (std::size_t first = begin; first < end; first += TakenPhotons::kBlocks)
                gather(first, std::min(end, first + TakenPhotons::kBlocks), taken,
                       lists[begin / kBlocks]);
        });
        std::vector<PathLight> all;
        for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
        return all;
    }

private:
    void gather(std::size_t begin, std::size_t end, TakenPhotons& taken,
                std::vector<PathLight>& list) const {
        if (!find_taken(context_.index, photons_, begin, end, taken)) return;
        for (std::size_t b = begin; b < end; ++b) {
            const TakenPhotons::Block& found = taken.blocks[b - begin];
            for (std::size_t i = 0; i < found.count; ++i) add(b, taken.list[found.first + i], list);
        }
    }

    void add(std::size_t block, const TakenPhoton& taken, std::vector<PathLight>& list) const {
        const MortonKey& origin = photons_.origin(taken.photon);
        const std::uint32_t path = chunks_[origin.list].paths[origin.item];
        const Photon& photon = photons_[taken.photon];
        for (unsigned rest = taken.accepting; rest != 0; rest &= rest - 1) {
            const auto i = static_cast<unsigned>(__builtin_ctz(rest));
            const VisiblePoint& point =
                context_.index.points()[block * VisiblePointIndex::kWidth + i];
            const float radius = context_.index.radius(block, i, photon.kind);
            const Vec3 rgb = context_.scene.wavelengths.to_rgb(
                light_of(context_.scene, point, photon) * share_of(point, photon.kind, radius, 1));
            const double y = luminance({rgb.x, rgb.y, rgb.z});
            if (y > 0)
                list.push_back(
                    {path, static_cast<std::uint32_t>(blocks_.block_of(point.pixel)), y});
        }
    }

    const PhotonContext& context_;
    const BlockGrid& blocks_;
    const std::vector<PhotonChunk>& chunks_;
    SortedPhotons photons_;
};

/// Where a path starts.
struct Start {
    EmissionPoint point{};
    double weight = 1;
};

Start start_of(GuidedPoints::Reader reader) {
    Start start;
    for (std::uint32_t s = 0; s < kGuidedDimensions; ++s) start.point[s] = to_unit(reader(s));
    start.weight = reader.weight();
    return start;
}

/// Sums the entries of each path and block.
std::vector<PathLight> summed(std::vector<PathLight> entries) {
    const auto key = [](const PathLight& e) { return std::tie(e.path, e.block); };
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const PathLight& a, const PathLight& b) { return key(a) < key(b); });
    std::vector<PathLight> sums;
    for (const PathLight& entry : entries)
        if (!sums.empty() && key(sums.back()) == key(entry))
            sums.back().luminance += entry.luminance;
        else
            sums.push_back(entry);
    return sums;
}

}  // namespace

PathTrials try_paths(const PhotonContext& context, const EmissionGuide& guide,
                     const BlockGrid& blocks, PassId pass, std::uint32_t count) {
    const PhotonTracer tracer(context.scene, context.transport, context.scene.scene.light_choice());
    const GuidedPoints points(pass, guide);
    const std::vector<PhotonChunk> chunks =
        trace_chunks(tracer, points, {0, count},
                     [&](const Photon& photon) { return context.index.may_accept(photon); });
    std::vector<Start> starts(count);
    parallel_blocks(count, kChunkPaths, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            starts[i] = start_of(points.path(static_cast<std::uint32_t>(i)));
    });
    PathTrials trials;
    for (const Start& start : starts) trials.points.push_back(start.point);
    trials.light = summed(TrialGatherer(context, blocks, chunks).gather());
    for (PathLight& light : trials.light) light.luminance /= starts[light.path].weight;
    return trials;
}

}  // namespace sunfleck::engine
