// The stages of one pass, in the order of the data flow. Only this room calls them.
#include "render/pass.h"

#include "core/stopwatch.h"
#include "estimate/deposit.h"
#include "measurement/radius.h"
#include "photon/adaptive_paths.h"
#include "photon/uniform_paths.h"
#include "reference/bidirectional_integrator.h"
#include "reference/light_integrator.h"
#include "reference/metropolis_integrator.h"

#include <utility>

namespace sunfleck {
namespace {

/// Mapped paths draw their numbers as parts of their own, beyond those of all groups.
constexpr std::uint32_t kMappedParts = 256;

/// Counts uniform paths. @return the share of visible ones.
double count_uniform(Statistics& counts, Statistics& all) {
    const std::uint64_t visible = counts[Count::uniform_visible];
    counts[Count::distinct_visible] = counts[Count::visible_states] = visible;
    all += counts;
    return static_cast<double>(visible) / static_cast<double>(counts[Count::uniform_paths]);
}

/// The photons of a pass, group by group.
class PhotonStage {
public:
    PhotonStage(const PhotonView& view, const EyePass& eye, const RenderSettings& settings,
                PassResult& result)
        : view_(view), eye_(eye), settings_(settings), result_(result) {}

    void trace(const PhotonGroup& group) {
        const LadderPlan& plan = group.plan;
        GroupCounts counts{plan.paths() + group.mapped.paths, group.power_share, 0, {}};
        if (group.mapped.paths > 0) counts.visible_fraction = trace_mapped(group);
        if (plan.levels.empty()) {
            counts.visible_fraction = trace_uniform(group);
        } else {
            if (!octree_) octree_.emplace(octree_of(view_));
            const Depositor deposit(view_.scene, view_.index, result_.image, 1);
            AdaptivePaths paths = trace_adaptive_paths(
                view_, *octree_, eye_.id.with_part(group.part), group, deposit);
            result_.statistics += paths.statistics;
            counts.ladder = std::move(paths.ladder);
            counts.visible_fraction += counts.ladder.visible_fraction;
        }
        result_.visible_fraction += group.power_share * counts.visible_fraction;
        result_.groups.push_back(std::move(counts));
    }

private:
    /// @return the visible fraction.
    double trace_uniform(const PhotonGroup& group) {
        const PhotonTracer tracer(view_.scene, view_.transport, group.lights);
        const std::uint32_t paths = group.plan.uniform_paths;
        const Depositor deposit(view_.scene, view_.index, result_.image, paths);
        const UniformKind kind = settings_.photon.sampler == PhotonSampler::random
                                     ? UniformKind::random
                                     : UniformKind::uniform;
        Statistics counts = trace_uniform_paths(
            tracer, {kind, eye_.id.with_part(group.part), paths, nullptr},
            [&](const Photon& photon) { return view_.index.may_take(photon); }, deposit);
        return count_uniform(counts, result_.statistics);
    }

    /// @return the fraction of uniform paths that are visible and that the map covers.
    double trace_mapped(const PhotonGroup& group) {
        const PhotonTracer tracer(view_.scene, view_.transport, group.lights);
        const Depositor deposit(view_.scene, view_.index, result_.image, group.mapped.paths);
        const PassId id = eye_.id.with_part(group.part + kMappedParts);
        const MappedPoints points(id, group.mapped.map);
        double visible = 0;
        Statistics counts = trace_uniform_paths(
            tracer, {UniformKind::mapped, id, group.mapped.paths, &group.mapped.map},
            [&](const Photon& photon) { return view_.index.may_take(photon); }, deposit,
            [&](std::uint32_t number) { visible += points.path(number).weight(); });
        counts[Count::mapped_paths] = std::exchange(counts[Count::uniform_paths], 0);
        counts[Count::mapped_visible] = std::exchange(counts[Count::uniform_visible], 0);
        counts[Count::distinct_visible] = counts[Count::visible_states] =
            counts[Count::mapped_visible];
        result_.statistics += counts;
        return visible / group.mapped.paths;
    }

    const PhotonView& view_;
    const EyePass& eye_;
    const RenderSettings& settings_;
    PassResult& result_;
    std::optional<ViewOctree> octree_;  // ladders alone need it
};

void render_sppm(const PassScene& scene, const RenderSettings& settings, const EyePass& eye,
                 const std::vector<PhotonGroup>& groups, PassResult& result) {
    Stopwatch watch;
    auto points = trace_eye_paths(eye, result.image, result.statistics);
    result.seconds.eye = watch.lap();
    const VisiblePointIndex index(std::move(points), settings.transport.max_depth);
    result.seconds.index = watch.lap();
    const PhotonView view{scene, settings.transport, index};
    PhotonStage photons(view, eye, settings, result);
    for (const PhotonGroup& group : groups) photons.trace(group);
    result.seconds.photon = watch.lap();
}

}  // namespace

PixelWindow window_of(const FilmDescription& film) {
    if (!film.crop) return {0, 0, film.resolution.x, film.resolution.y};
    const auto& c = *film.crop;
    return {c[0], c[2], c[1], c[3]};
}

PassResult render_pass(const Scene& scene, const RenderSettings& settings, std::uint32_t number,
                       const Epoch& epoch) {
    const PixelWindow window = window_of(scene.film());
    const PassId id{settings.seed, number};
    const bool has_discs = settings.integrator == Integrator::sppm;
    PassResult result{PassImage(window.pixels(), settings.layers, has_discs),
                      {},
                      {},
                      radius_factor(number, settings.alpha),
                      0,
                      {}};
    Stopwatch watch;
    const PassScene at_wavelengths(scene, id);
    result.seconds.build = watch.lap();
    const EyePass eye{at_wavelengths,      settings.transport, settings.eye, window, id,
                      result.radius_factor};
    const ReferencePass reference{
        at_wavelengths, settings.transport, {window.x0, window.x1, window.y0, window.y1}, id};
    switch (settings.integrator) {
        case Integrator::sppm:
            render_sppm(at_wavelengths, settings, eye, epoch.groups, result);
            break;
        case Integrator::path:
            trace_reference_paths(reference, result.image, result.statistics);
            result.seconds.eye = watch.lap();
            break;
        case Integrator::bdpt:
            trace_bidirectional_paths(reference, result.image, result.statistics);
            result.seconds.eye = watch.lap();
            break;
        case Integrator::mlt:
            result.visible_fraction =
                trace_metropolis_chains(reference, result.image, result.statistics);
            result.seconds.photon = watch.lap();
            break;
        case Integrator::light: {
            Statistics counts;
            trace_light_paths(reference, epoch.paths, result.image, counts);
            result.visible_fraction = count_uniform(counts, result.statistics);
            result.seconds.photon = watch.lap();
            break;
        }
    }
    result.statistics[Count::dropped_nonfinite] += result.image.dropped();
    result.statistics[Count::saturated] += result.image.saturated();
    return result;
}

}  // namespace sunfleck
