// The stages of one pass, in the order of the data flow. Only this room calls them.
#include "render/pass.h"

#include "core/stopwatch.h"
#include "estimate/deposit.h"
#include "reference/path_integrator.h"
#include "render/radius.h"

namespace sunfleck {
namespace {

std::uint32_t paths_per_pass(const PhotonSettings& settings, std::size_t pixels) {
    constexpr std::uint32_t kLeast = 200'000;
    return settings.paths_per_pass.value_or(std::max(kLeast, static_cast<std::uint32_t>(pixels)));
}

void render_sppm(const PassScene& scene, const RenderSettings& settings, const EyePass& eye,
                 PassResult& result) {
    Stopwatch watch;
    auto points = trace_eye_paths(eye, result.image, result.statistics);
    result.seconds.eye = watch.lap();
    const VisiblePointIndex index(std::move(points), settings.transport.max_depth);
    result.seconds.index = watch.lap();

    const std::uint32_t paths = paths_per_pass(settings.photon, eye.window.pixels());
    const PhotonTracer tracer(scene, settings.transport);
    const Depositor deposit(scene, index, result.image, paths);
    result.statistics += trace_uniform_paths(
        tracer, {settings.photon.sampler, eye.id, paths},
        [&](const Vec3& position) { return index.may_take(position); }, deposit);
    result.seconds.photon = watch.lap();
}

}  // namespace

PixelWindow window_of(const FilmDescription& film) {
    if (!film.crop) return {0, 0, film.resolution.x, film.resolution.y};
    const auto& c = *film.crop;
    return {c[0], c[2], c[1], c[3]};
}

PassResult render_pass(const Scene& scene, const RenderSettings& settings, std::uint32_t number) {
    const PixelWindow window = window_of(scene.film());
    const PassId id{settings.seed, number};
    PassResult result{
        PassImage(window.pixels(), settings.layers), {}, {}, radius_factor(number, settings.alpha)};
    Stopwatch watch;
    const PassScene at_wavelengths(scene, id);
    result.seconds.build = watch.lap();
    const EyePass eye{at_wavelengths,      settings.transport, settings.eye, window, id,
                      result.radius_factor};
    if (settings.integrator == Integrator::path) {
        trace_reference_paths(
            {at_wavelengths, settings.transport, {window.x0, window.x1, window.y0, window.y1}, id},
            result.image, result.statistics);
        result.seconds.eye = watch.lap();
    } else {
        render_sppm(at_wavelengths, settings, eye, result);
    }
    result.statistics[Count::dropped_nonfinite] += result.image.dropped();
    result.statistics[Count::saturated] += result.image.saturated();
    return result;
}

}  // namespace sunfleck
