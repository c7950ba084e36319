// Uniform paths, guided paths and splittings of each stratum.
#include "stages/photon_stage.h"

#include "estimate/deposit.h"
#include "photon/adaptive_paths.h"
#include "photon/uniform_paths.h"

#include <optional>
#include <utility>

namespace sunfleck::engine {
namespace {

class PhotonStage {
public:
    PhotonStage(const PhotonContext& view, PassId id, PhotonSampler sampler, const PhotonTarget& to)
        : view_(view), id_(id), sampler_(sampler), to_(to) {}

    PhotonTotals take() { return std::move(result_); }

    void trace(const LightStratum& stratum) {
        const SplittingPlan& plan = stratum.plan;
        StratumCounts counts{stratum.paths(), stratum.power_share, 0, {}};
        if (plan.levels.empty()) {
            counts.visible_fraction = trace_uniform(stratum);
        } else {
            if (!octree_) octree_.emplace(octree_of(view_));
            const Depositor deposit(view_.scene, view_.index, to_.image, 1, to_.taken);
            AdaptivePaths paths = trace_adaptive_paths(view_, *octree_, id_.with_part(stratum.part),
                                                       stratum, deposit);
            result_.statistics += paths.statistics;
            counts.splitting = std::move(paths.splitting);
            counts.visible_fraction = counts.splitting.visible_fraction;
        }
        result_.visible_fraction += stratum.power_share * counts.visible_fraction;
        result_.strata.push_back(std::move(counts));
    }

private:
    /// @return the visible fraction.
    double trace_uniform(const LightStratum& stratum) {
        const PhotonTracer tracer(view_.scene, view_.transport, stratum.lights);
        const std::uint32_t paths = stratum.plan.uniform_paths;
        const Depositor deposit(view_.scene, view_.index, to_.image, paths, to_.taken);
        const UniformKind kind =
            sampler_ == PhotonSampler::random ? UniformKind::random : UniformKind::uniform;
        Statistics counts = trace_uniform_paths(
            tracer, {kind, id_.with_part(stratum.part), paths},
            [&](const Photon& photon) { return view_.index.may_accept(photon); }, deposit);
        return count_uniform(counts, result_.statistics);
    }

    const PhotonContext& view_;
    PassId id_;
    PhotonSampler sampler_;
    const PhotonTarget& to_;
    PhotonTotals result_;
    std::optional<VisiblePointOctree> octree_;  // splittings alone need it
};

}  // namespace

void PhotonTotals::add(const PhotonTotals& subpass, double share) {
    statistics += subpass.statistics;
    visible_fraction += subpass.visible_fraction * share;
    strata.resize(subpass.strata.size());
    for (std::size_t g = 0; g < strata.size(); ++g) strata[g].add(subpass.strata[g], share);
}

PhotonTotals trace_photons(const PhotonContext& view, PassId id, PhotonSampler sampler,
                           const std::vector<LightStratum>& strata, const PhotonTarget& to) {
    PhotonStage stage(view, id, sampler, to);
    for (const LightStratum& stratum : strata) stage.trace(stratum);
    return stage.take();
}

double count_uniform(Statistics& counts, Statistics& all) {
    const std::uint64_t visible = counts[Count::uniform_visible];
    counts[Count::distinct_visible] = counts[Count::visible_states] = visible;
    all += counts;
    return static_cast<double>(visible) / static_cast<double>(counts[Count::uniform_paths]);
}

}  // namespace sunfleck::engine
