// The stages of one pass, in the order of the data flow. Only this file calls them.
#include "render/pass.h"

#include "camera_paths/trace_camera_paths.h"
#include "core/stopwatch.h"
#include "film/pass_weight.h"
#include "photon_samplers/samplers.h"
#include "planning/photon_trials.h"
#include "reference/bidirectional_integrator.h"
#include "reference/light_integrator.h"
#include "reference/metropolis_integrator.h"
#include "visible_points/radius.h"

#include <utility>

namespace sunfleck::engine {
namespace {

/// @param is_small  whether the pass has a part of its epoch's paths (film/pass_weight.h).
void render_sppm(const RenderSettings& settings, CameraPass camera, const Epoch& epoch,
                 bool is_small, SamplerState& state, PassResult& result) {
    std::vector<LightStratum> fewer;
    if (is_small)
        fewer = fraction_of(epoch.strata, 1U << kSmallPassBits);
    else
        camera.log2_samples = epoch.log2_samples;
    const std::vector<LightStratum>& strata = is_small ? fewer : epoch.strata;
    camera.edges = epoch.edges;
    camera.direct_in_media = epoch.direct_in_media;
    Stopwatch watch;
    auto points = trace_camera_paths(camera, result.image, result.statistics);
    if (const auto factor = shrink_radii(state, points)) result.radius_factor = *factor;
    result.seconds.camera += watch.lap();
    const VisiblePointIndex index(std::move(points), camera.transport.max_depth);
    result.seconds.index += watch.lap();
    const PhotonContext photon_context{camera.scene, camera.transport, index};
    const bool are_counted = result.image.has(Aov::samples);
    PhotonCounts taken(are_counted ? result.image.pixels() : 0);
    PhotonTotals photons = trace_photons({photon_context, camera.id, strata, settings.photon},
                                         {result.image, are_counted ? &taken : nullptr}, state);
    result.seconds.photon += watch.lap();
    if (are_counted) add_samples(taken, result.image);
    result.statistics += photons.statistics;
    result.visible_fraction = photons.visible_fraction;
    result.strata = std::move(photons.strata);
    result.sums = std::move(photons.sums);
}

}  // namespace

PassResult render_pass(const Scene& scene, const RenderSettings& settings, std::uint32_t number,
                       const Epoch& epoch, SamplerState& state) {
    const PixelWindow window = window_of(scene.film());
    const PassId id{settings.seed, number};
    const bool sequential = is_sequential(settings);  // its state sets the radii
    const bool has_discs = settings.integrator == Integrator::sppm && !sequential;
    std::optional<BlockGrid> photon_cells;
    if (has_discs) photon_cells = photon_cells_of(window.width(), window.height());
    PassResult result{PassImage(window.pixels(), settings.aovs, photon_cells,
                                settings.transport.light_groups.names.size()),
                      {},
                      {},
                      sequential ? 1 : radius_factor(number, settings.alpha),
                      0,
                      {},
                      epoch.transport.indirect};
    // A state counts passes: a black one, too, goes the whole way.
    if (scene.is_dark() && settings.aovs == AovSet{} && !sequential) return result;
    Stopwatch watch;
    const PassScene at_wavelengths(scene, id);
    result.seconds.build = watch.lap();
    const CameraPass camera{at_wavelengths,      epoch.transport, settings.camera, window, id,
                            result.radius_factor};
    const ReferencePass reference{at_wavelengths, settings.transport, window, id};
    switch (settings.integrator) {
        case Integrator::sppm:
            render_sppm(settings, camera, epoch, is_small_pass(settings, window.pixels(), number),
                        state, result);
            break;
        case Integrator::path:
            trace_reference_paths(reference, result.image, result.statistics);
            result.seconds.camera = watch.lap();
            break;
        case Integrator::bdpt:
            trace_bidirectional_paths(reference, result.image, result.statistics);
            result.seconds.camera = watch.lap();
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

}  // namespace sunfleck::engine
