// Uniform paths, mapped paths and ladders of each group.
#include "stages/photon_stage.h"

#include "estimate/deposit.h"
#include "photon/adaptive_paths.h"
#include "photon/uniform_paths.h"

#include <optional>
#include <utility>

namespace sunfleck {
namespace {

class PhotonStage {
public:
    PhotonStage(const PhotonView& view, PassId id, PhotonSampler sampler, const PhotonTarget& to)
        : view_(view), id_(id), sampler_(sampler), to_(to) {}

    PhotonTotals take() { return std::move(result_); }

    void trace(const PhotonGroup& group) {
        const LadderPlan& plan = group.plan;
        GroupCounts counts{group.paths(), group.power_share, 0, {}};
        if (plan.levels.empty()) {
            counts.visible_fraction = trace_uniform(group);
        } else {
            if (!octree_) octree_.emplace(octree_of(view_));
            const Depositor deposit(view_.scene, view_.index, to_.image, 1, to_.taken);
            AdaptivePaths paths =
                trace_adaptive_paths(view_, *octree_, id_.with_part(group.part), group, deposit);
            result_.statistics += paths.statistics;
            counts.ladder = std::move(paths.ladder);
            counts.visible_fraction = counts.ladder.visible_fraction;
        }
        result_.visible_fraction += group.power_share * counts.visible_fraction;
        result_.groups.push_back(std::move(counts));
    }

private:
    /// @return the visible fraction.
    double trace_uniform(const PhotonGroup& group) {
        const PhotonTracer tracer(view_.scene, view_.transport, group.lights);
        const std::uint32_t paths = group.plan.uniform_paths;
        const Depositor deposit(view_.scene, view_.index, to_.image, paths, to_.taken);
        const UniformKind kind =
            sampler_ == PhotonSampler::random ? UniformKind::random : UniformKind::uniform;
        Statistics counts = trace_uniform_paths(
            tracer, {kind, id_.with_part(group.part), paths},
            [&](const Photon& photon) { return view_.index.may_take(photon); }, deposit);
        return count_uniform(counts, result_.statistics);
    }

    const PhotonView& view_;
    PassId id_;
    PhotonSampler sampler_;
    const PhotonTarget& to_;
    PhotonTotals result_;
    std::optional<ViewOctree> octree_;  // ladders alone need it
};

}  // namespace

void PhotonTotals::add(const PhotonTotals& draw, double share) {
    statistics += draw.statistics;
    visible_fraction += draw.visible_fraction * share;
    groups.resize(draw.groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) groups[g].add(draw.groups[g], share);
}

PhotonTotals trace_photons(const PhotonView& view, PassId id, PhotonSampler sampler,
                           const std::vector<PhotonGroup>& groups, const PhotonTarget& to) {
    PhotonStage stage(view, id, sampler, to);
    for (const PhotonGroup& group : groups) stage.trace(group);
    return stage.take();
}

double count_uniform(Statistics& counts, Statistics& all) {
    const std::uint64_t visible = counts[Count::uniform_visible];
    counts[Count::distinct_visible] = counts[Count::visible_states] = visible;
    all += counts;
    return static_cast<double>(visible) / static_cast<double>(counts[Count::uniform_paths]);
}

}  // namespace sunfleck
