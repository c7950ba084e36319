// The ladder's paths become photons.
#include "photon/adaptive_paths.h"

#include "photon/photon_space.h"
#include "random_numbers/emission_points.h"

namespace sunfleck {
namespace {

/// One batch a chain, or a block of paths through a map.
struct PhotonSink {
    struct Collector {
        PhotonBatch batch;
        std::uint32_t paths = 0;

        void operator()(const PhotonPath& path, double weight) {
            for (const Photon& photon : path.photons) {
                batch.add(photon, paths);
                batch.photons.back().flux *= static_cast<float>(weight);
            }
            ++paths;
        }
    };

    const DepositBatches& deposit;
    Statistics& statistics;

    Collector make() { return {}; }
    void take(std::vector<Collector>&& chains) {
        std::vector<PhotonBatch> batches;
        batches.reserve(chains.size());
        for (Collector& chain : chains) batches.push_back(std::move(chain.batch));
        statistics += deposit(batches);
    }
};

}  // namespace

AdaptivePaths trace_adaptive_paths(const PhotonView& view, const ViewOctree& octree, PassId pass,
                                   const PhotonGroup& group, const DepositBatches& deposit) {
    const PhotonTracer tracer(view.scene, view.transport, group.lights);
    const PhotonSpace space(tracer, view.index, octree);
    const EmissionPoints points(pass);
    AdaptivePaths paths;
    auto& [ladder, counts] = paths;
    PhotonSink sink{deposit, counts};
    Statistics traced;
    ladder = Ladder(space, points, pass, group.plan, group.mapped).run(sink, traced);
    counts += traced;
    counts[Count::uniform_paths] += group.plan.uniform_paths;
    counts[Count::uniform_visible] += ladder.levels.front().at_least(kVisible);
    const Acceptance mutations = ladder.mutations();
    counts[Count::mutated_paths] += mutations.proposed;
    counts[Count::accepted_paths] += mutations.accepted;
    const std::uint64_t mapped_visible = ladder.mapped.at_least(kVisible);
    counts[Count::mapped_paths] += ladder.mapped.states;
    counts[Count::mapped_visible] += mapped_visible;
    counts[Count::distinct_visible] += mapped_visible;
    counts[Count::visible_states] += mapped_visible;
    if (ladder.levels.size() <= group.plan.levels.size()) return paths;  // starved
    const LevelCounts& last = ladder.levels.back();
    const bool brings_all =
        group.mapped.own_share < 1;  // else the map's paths bring what it covers
    counts[Count::distinct_visible] += last.distinct - (brings_all ? 0 : last.distinct_covered);
    counts[Count::visible_states] += last.states - (brings_all ? 0 : last.covered);
    return paths;
}

}  // namespace sunfleck
