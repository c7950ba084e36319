// Splitting and guided paths of each stratum, or uniform paths.
#include "photon_samplers/splitting_sampler.h"

#include "estimate/deposit.h"
#include "photon/adaptive_paths.h"

#include <optional>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Traces the strata of a pass.
class StrataTracer {
public:
    StrataTracer(const PhotonPass& pass, const PhotonTarget& target)
        : pass_(pass), target_(target) {}

    PhotonTotals trace() {
        for (const LightStratum& stratum : pass_.strata) {
            StratumCounts counts{stratum.paths(), stratum.power_share, 0, {}};
            if (stratum.has_full_guide())
                trace_by_guide(stratum, counts);
            else if (stratum.plan.levels.empty())
                counts.visible_fraction =
                    trace_uniform_stratum(pass_, UniformKind::uniform, stratum, target_, totals_);
            else
                take(
                    trace_adaptive_paths(context(), octree(), id_of(stratum), stratum, depositor()),
                    counts);
            totals_.add_stratum(std::move(counts));
        }
        return std::move(totals_);
    }

private:
    void trace_by_guide(const LightStratum& stratum, StratumCounts& counts) {
        const TracedPaths guided = trace_guided_paths(pass_, stratum, target_, totals_);
        counts.visible_fraction = guided.visible_weight / stratum.guided.paths;
        if (stratum.plan.levels.empty()) return;
        const GuidedRemainder rest{id_of(stratum), stratum.guided, stratum.plan.levels.back(),
                                   guided.bounded};
        take(trace_remainder(context(), octree(), stratum.lights, rest, depositor()), counts);
    }

    void take(AdaptivePaths&& paths, StratumCounts& counts) {
        totals_.statistics += paths.statistics;
        counts.splitting = std::move(paths.splitting);
        counts.visible_fraction += counts.splitting.visible_fraction;
    }

    const PhotonContext& context() const { return pass_.photon_context; }
    PassId id_of(const LightStratum& stratum) const {
        return pass_.id.with_stratum(stratum.number);
    }
    Depositor depositor() const {
        return {context().scene, context().index, target_.image, 1, target_.taken};
    }
    /// Chains alone need it.
    const VisiblePointOctree& octree() {
        if (!octree_) octree_.emplace(octree_of(context()));
        return *octree_;
    }

    const PhotonPass& pass_;
    const PhotonTarget& target_;
    PhotonTotals totals_;
    std::optional<VisiblePointOctree> octree_;
};

}  // namespace

PhotonTotals SplittingSampler::trace(const PhotonPass& pass, const PhotonTarget& target, State&) {
    return StrataTracer(pass, target).trace();
}

}  // namespace sunfleck::engine
