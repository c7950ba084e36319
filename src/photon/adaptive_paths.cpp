// Conversion of the splitting's paths to photons.
#include "photon/adaptive_paths.h"

#include "photon/photon_space.h"
#include "random_numbers/emission_points.h"

namespace sunfleck::engine {
namespace {

/// One chunk per chain, or per block of guided paths.
struct PhotonSink {
    struct Collector {
        PhotonChunk chunk;
        std::uint32_t paths = 0;

        void operator()(const PhotonPath& path, double weight) {
            for (const Photon& photon : path.photons) {
                chunk.add(photon, paths);
                chunk.photons.back().flux *= static_cast<float>(weight);
            }
            ++paths;
        }
    };

    const DepositChunks& deposit;
    Statistics& statistics;

    Collector make() { return {}; }
    void take(std::vector<Collector>&& chains) {
        std::vector<PhotonChunk> chunks;
        chunks.reserve(chains.size());
        for (Collector& chain : chains) chunks.push_back(std::move(chain.chunk));
        statistics += deposit(chunks);
    }
};

/// Counts the mutations, and the states of the last level, if it was reached.
void count_chains(const SplittingCounts& splitting, std::size_t levels, Statistics& counts) {
    const Acceptance mutations = splitting.mutations();
    counts[Count::mutated_paths] += mutations.proposed;
    counts[Count::accepted_paths] += mutations.accepted;
    if (splitting.levels.size() <= levels) return;  // starved
    counts[Count::distinct_visible] += splitting.levels.back().distinct_lighting;
    counts[Count::visible_states] += splitting.levels.back().lighting;
}

}  // namespace

AdaptivePaths trace_adaptive_paths(const PhotonContext& photon_context,
                                   const VisiblePointOctree& octree, PassId pass,
                                   const LightStratum& stratum, const DepositChunks& deposit) {
    const PhotonTracer tracer(photon_context.scene, photon_context.transport, stratum.lights);
    const PhotonSpace space(tracer, photon_context.index, octree);
    const EmissionPoints points(pass);
    AdaptivePaths paths;
    auto& [splitting, counts] = paths;
    PhotonSink sink{deposit, counts};
    Statistics traced;
    splitting = Splitting(space, points, pass, stratum.plan, stratum.guided).run(sink, traced);
    counts += traced;
    counts[Count::uniform_paths] += stratum.plan.uniform_paths;
    counts[Count::uniform_visible] += splitting.levels.front().at_least(kVisible);
    const std::uint64_t guided_visible = splitting.guided.at_least(kVisible);
    counts[Count::guided_paths] += splitting.guided.states;
    counts[Count::guided_visible] += guided_visible;
    counts[Count::distinct_visible] += guided_visible;
    counts[Count::visible_states] += guided_visible;
    count_chains(splitting, stratum.plan.levels.size(), counts);
    return paths;
}

AdaptivePaths trace_remainder(const PhotonContext& photon_context, const VisiblePointOctree& octree,
                              const LightChoice& lights, const GuidedRemainder& rest,
                              const DepositChunks& deposit) {
    const PhotonTracer tracer(photon_context.scene, photon_context.transport, lights);
    const PhotonSpace space(tracer, photon_context.index, octree);
    AdaptivePaths paths;
    auto& [splitting, counts] = paths;
    PhotonSink sink{deposit, counts};
    Statistics traced;
    splitting = bring_remainder(space, rest, sink, traced);
    counts += traced;
    count_chains(splitting, 1, counts);
    return paths;
}

}  // namespace sunfleck::engine
