// The ladder's paths become photons.
#include "photon/adaptive_paths.h"

#include "photon/photon_space.h"
#include "sampler/emission_points.h"

namespace sunfleck {
namespace {

/// The tracer, the octree and the space that stands on both.
struct Ground {
    PhotonTracer tracer;
    ViewOctree octree;
    PhotonSpace space;

    explicit Ground(const PhotonView& view)
        : tracer(view.scene, view.transport),
          octree(view.index.points(), view.scene.scene.sphere().center,
                 view.scene.scene.sphere().radius),
          space(tracer, view.index, octree) {}
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;
};

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

PilotResult learn_ladder(const PhotonView& view, std::uint64_t seed, std::uint32_t epoch,
                         std::uint32_t paths) {
    const Ground ground(view);
    return Pilot<PhotonSpace, EmissionPoints>(ground.space, seed, epoch, paths).run();
}

LadderCounts trace_adaptive_paths(const PhotonView& view, PassId pass, const LadderPlan& plan,
                                  const DepositBatches& deposit, Statistics& statistics) {
    const Ground ground(view);
    PhotonSink sink{deposit, statistics};
    Statistics traced;
    LadderCounts counts = run_ladder(ground.space, EmissionPoints(pass), pass, plan, sink, traced);
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
