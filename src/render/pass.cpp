// The stages of one pass, in the order of the data flow. Only this room calls them.
#include "render/pass.h"

#include "core/stopwatch.h"
#include "estimate/deposit.h"
#include "photon/adaptive_paths.h"
#include "photon/uniform_paths.h"
#include "reference/bidirectional_integrator.h"
#include "reference/light_integrator.h"
#include "reference/metropolis_integrator.h"
#include "render/radius.h"

namespace sunfleck {
namespace {

void count_uniform(Statistics& counts, PassResult& result) {
    const std::uint64_t visible = counts[Count::uniform_visible];
    counts[Count::distinct_visible] = counts[Count::visible_states] = visible;
    result.visible_fraction =
        static_cast<double>(visible) / static_cast<double>(counts[Count::uniform_paths]);
    result.statistics += counts;
}

void trace_photons(const PhotonView& view, const EyePass& eye, const RenderSettings& settings,
                   const LadderPlan& plan, PassResult& result) {
    if (plan.levels.empty()) {
        const PhotonTracer tracer(view.scene, view.transport);
        const Depositor deposit(view.scene, view.index, result.image, plan.uniform_paths);
        const UniformKind kind = settings.photon.sampler == PhotonSampler::random
                                     ? UniformKind::random
                                     : UniformKind::uniform;
        Statistics counts = trace_uniform_paths(
            tracer, {kind, eye.id, plan.uniform_paths},
            [&](const Photon& photon) { return view.index.may_take(photon); }, deposit);
        count_uniform(counts, result);
        return;
    }
    const Depositor deposit(view.scene, view.index, result.image, 1);
    result.ladder = trace_adaptive_paths(view, eye.id, plan, deposit, result.statistics);
    result.visible_fraction = visible_fraction(plan, result.ladder);
}

void render_sppm(const PassScene& scene, const RenderSettings& settings, const EyePass& eye,
                 const LadderPlan& plan, PassResult& result) {
    Stopwatch watch;
    auto points = trace_eye_paths(eye, result.image, result.statistics);
    result.seconds.eye = watch.lap();
    const VisiblePointIndex index(std::move(points), settings.transport.max_depth);
    result.seconds.index = watch.lap();
    trace_photons({scene, settings.transport, index}, eye, settings, plan, result);
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
    PassResult result{PassImage(window.pixels(), settings.layers), {}, {},
                      radius_factor(number, settings.alpha),       0,  {}};
    Stopwatch watch;
    const PassScene at_wavelengths(scene, id);
    result.seconds.build = watch.lap();
    const EyePass eye{at_wavelengths,      settings.transport, settings.eye, window, id,
                      result.radius_factor};
    const ReferencePass reference{
        at_wavelengths, settings.transport, {window.x0, window.x1, window.y0, window.y1}, id};
    switch (settings.integrator) {
        case Integrator::sppm:
            render_sppm(at_wavelengths, settings, eye, epoch.plan, result);
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
            trace_light_paths(reference, epoch.plan.uniform_paths, result.image, counts);
            count_uniform(counts, result);
            result.seconds.photon = watch.lap();
            break;
        }
    }
    result.statistics[Count::dropped_nonfinite] += result.image.dropped();
    result.statistics[Count::saturated] += result.image.saturated();
    return result;
}

}  // namespace sunfleck
