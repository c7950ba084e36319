// A pilot and trials over views like that of the epoch's first pass.
#include "planning/epoch.h"

#include "core/stopwatch.h"
#include "film/target_error.h"
#include "math/wavelengths.h"
#include "photon/light_strata.h"
#include "photon_samplers/samplers.h"
#include "planning/photon_budget.h"
#include "planning/trial_iterations.h"
#include "visible_points/radius.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// The first epoch is too short for a budget to pay, and for trials as large as those of others;
/// long ones can pay for more.
SubpassRequest request_of(const PhotonSettings& settings, std::uint32_t epoch, std::uint32_t usual,
                          std::size_t pixels) {
    constexpr std::size_t kLarge = 1'000'000;  // so many know enough by every fourth
    SubpassRequest request;
    request.usual = usual;
    request.budget = settings.photon_budget && !settings.paths_per_pass;
    if (pixels > kLarge) request.cells = 2;
    if (epoch == 0) request = {usual, false, true, {1, 3}, 16, 2};
    request.views.pairs_of_nets = std::clamp(first_pass_of(epoch) / 32, 1U, 8U);
    request.shares = settings.adaptive_pixels;
    return request;
}

/// The passes by which it is measured what learning may cost: those of the epoch, or as many as the
/// error of a picture asks for.
std::uint64_t worth_learning(std::uint32_t epoch) {
    const std::uint64_t passes = first_pass_of(epoch + 1) - first_pass_of(epoch);
    return std::max(passes, kTargetBatches * kBatchPasses);
}

}  // namespace

bool needs_learning(const Scene& scene, const RenderSettings& settings) {
    return !scene.is_dark() && settings.integrator == Integrator::sppm &&
           learns(settings.photon.sampler);
}

Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                  const std::function<void(double)>& view_traced) {
    Stopwatch watch;
    const PixelWindow window = window_of(scene.film());
    const std::uint32_t paths = usual_paths(settings.photon, window.pixels());
    Epoch epoch{epoch_of(pass), paths, 1, 1, {}, {}, 0};
    if (scene.is_dark() && settings.integrator == Integrator::sppm) {
        epoch.paths = 0;
        return epoch;
    }
    if (!needs_learning(scene, settings) || paths < 2) {
        epoch.strata.push_back({scene.light_choice(), {paths, {}}, {}});
        return epoch;
    }
    const std::uint32_t first = first_pass_of(epoch.number);
    const PassScene at_wavelengths(scene, {settings.seed, first});
    const PilotName name{settings.seed, epoch.number};
    const CameraPass camera{at_wavelengths,
                            settings.transport,
                            settings.camera,
                            window,
                            name.iteration(kExploredTrialIteration),
                            radius_factor(first, settings.alpha)};
    watch.lap();
    const CameraTrial seen = view_of(camera);
    if (view_traced) view_traced(watch.lap());
    const PhotonContext view{at_wavelengths, settings.transport, seen.index};
    const std::uint64_t work = worth_learning(epoch.number) * (paths + window.pixels());
    LightPlanner planner(view, settings.photon, name, work);
    epoch.strata = planner.plan(paths);
    const SubpassRequest request =
        request_of(settings.photon, epoch.number, paths, window.pixels());
    SubpassPlan plan = measured_plan(camera, seen, epoch.strata, name, request);
    epoch.log2_samples = std::move(plan.log2_samples);
    if (request.budget) {
        const PhotonBudget& budget = plan.budget;
        if (budget.paths > paths) epoch.strata = planner.plan(budget.paths);
        if (budget.paths < paths)
            epoch.strata = part_of(std::move(epoch.strata), paths / budget.paths);
        epoch.paths = static_cast<std::uint32_t>(paths_of(epoch.strata));
        epoch.subpasses = budget.subpasses;
        epoch.weight = settings.photon.pass_weights ? budget.weight : 1;
    }
    epoch.seconds = watch.seconds();
    return epoch;
}

}  // namespace sunfleck::engine
