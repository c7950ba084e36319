// Splitting and guided paths of each stratum, or uniform paths.
#include "photon_samplers/splitting_sampler.h"

#include "estimate/deposit.h"
#include "photon/adaptive_paths.h"

#include <optional>
#include <utility>

namespace sunfleck::engine {

PhotonTotals SplittingSampler::trace(const PhotonPass& pass, const PhotonTarget& target, State&) {
    const PhotonContext& photon_context = pass.photon_context;
    PhotonTotals totals;
    std::optional<VisiblePointOctree> octree;  // splitting alone needs it
    for (const LightStratum& stratum : pass.strata) {
        StratumCounts counts{stratum.paths(), stratum.power_share, 0, {}};
        if (stratum.is_guided_alone()) {
            counts.visible_fraction = trace_guided_stratum(pass, stratum, target, totals);
        } else if (stratum.plan.levels.empty()) {
            counts.visible_fraction =
                trace_uniform_stratum(pass, UniformKind::uniform, stratum, target, totals);
        } else {
            if (!octree) octree.emplace(octree_of(photon_context));
            const Depositor deposit(photon_context.scene, photon_context.index, target.image, 1,
                                    target.taken);
            AdaptivePaths paths = trace_adaptive_paths(
                photon_context, *octree, pass.id.with_stratum(stratum.number), stratum, deposit);
            totals.statistics += paths.statistics;
            counts.splitting = std::move(paths.splitting);
            counts.visible_fraction = counts.splitting.visible_fraction;
        }
        totals.add_stratum(std::move(counts));
    }
    return totals;
}

}  // namespace sunfleck::engine
