// The ladder's paths become photons.
#include "photon/adaptive_paths.h"

#include "photon/photon_space.h"
#include "sampler/emission_points.h"

namespace sunfleck {
namespace {

/// One batch a chain.
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
        for (Collector& chain : chains) batches.push_back(std::move(chain.batch));
        statistics += deposit(batches);
    }
};

}  // namespace

LadderCounts trace_adaptive_paths(const PhotonView& view, const ViewOctree& octree, PassId pass,
                                  const PhotonGroup& group, const DepositBatches& deposit,
                                  Statistics& statistics) {
    const PhotonTracer tracer(view.scene, view.transport, group.lights);
    const PhotonSpace space(tracer, view.index, octree);
    const LadderPlan& plan = group.plan;
    PhotonSink sink{deposit, statistics};
    Statistics traced;
    LadderCounts counts =
        run_ladder(space, EmissionPoints(pass), pass, plan, sink, traced, group.mapped.as_bridge());
    statistics += traced;
    statistics[Count::uniform_paths] += plan.uniform_paths;
    statistics[Count::uniform_visible] += counts.levels.front().at_least(kVisible);
    const Acceptance mutations = counts.mutations();
    statistics[Count::mutated_paths] += mutations.proposed;
    statistics[Count::accepted_paths] += mutations.accepted;
    if (counts.levels.size() <= plan.levels.size()) return counts;  // starved
    const LevelCounts& last = counts.levels.back();
    statistics[Count::distinct_visible] += last.distinct;
    statistics[Count::visible_states] += last.states;
    return counts;
}

}  // namespace sunfleck
