// A pilot over the visible points of the epoch's first pass.
#include "render/epoch.h"

#include "core/stopwatch.h"
#include "measurement/radius.h"
#include "photon/light_groups.h"
#include "render/pass.h"

namespace sunfleck {
namespace {

std::uint32_t paths_per_pass(const PhotonSettings& settings, std::size_t pixels) {
    constexpr std::uint32_t kLeast = 200'000;
    return settings.paths_per_pass.value_or(std::max(kLeast, static_cast<std::uint32_t>(pixels)));
}

}  // namespace

Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass) {
    const Stopwatch watch;
    const PixelWindow window = window_of(scene.film());
    const std::uint32_t paths = paths_per_pass(settings.photon, window.pixels());
    Epoch epoch{epoch_of(pass), paths, {}, 0};
    if (settings.integrator != Integrator::sppm ||
        settings.photon.sampler != PhotonSampler::adaptive || paths < 2) {
        epoch.groups.push_back({scene.light_choice(), {paths, {}}, {}});
        return epoch;
    }
    const PassId first{settings.seed, first_pass_of(epoch.number)};
    const PassScene at_wavelengths(scene, first);
    PassImage unused(window.pixels(), {});
    Statistics counts;
    const EyePass eye{at_wavelengths, settings.transport,
                      settings.eye,   window,
                      first,          radius_factor(first.number, settings.alpha)};
    const VisiblePointIndex index(trace_eye_paths(eye, unused, counts),
                                  settings.transport.max_depth);
    const PhotonView view{at_wavelengths, settings.transport, index};
    const PilotName name{settings.seed, epoch.number};
    if (settings.photon.light_groups)
        epoch.groups = learn_light_groups(view, settings.photon, name, paths);
    else
        epoch.groups.push_back(learn_one_group(view, settings.photon, name, paths));
    epoch.seconds = watch.seconds();
    return epoch;
}

}  // namespace sunfleck
