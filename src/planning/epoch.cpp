// A pilot and trials over views like that of the epoch's first pass.
#include "planning/epoch.h"

#include "core/stopwatch.h"
#include "film/target_error.h"
#include "math/wavelengths.h"
#include "photon/light_strata.h"
#include "planning/photon_budget.h"
#include "planning/trial_iterations.h"
#include "visible_points/radius.h"

#include <algorithm>
#include <utility>

namespace sunfleck {
namespace {

/// The first epoch is too short for a balance to pay, and for trials as large as those of others;
/// long ones can pay for more.
DrawWishes wishes_of(const PhotonSettings& settings, std::uint32_t epoch, std::uint32_t usual,
                     std::size_t pixels) {
    constexpr std::size_t kLarge = 1'000'000;  // so many know enough by every fourth
    DrawWishes wishes;
    wishes.usual = usual;
    wishes.balance = settings.balance && !settings.paths_per_pass;
    if (pixels > kLarge) wishes.cells = 2;
    if (epoch == 0) wishes = {usual, false, true, {1, 3}, 16, 2};
    wishes.views.pairs_of_nets = std::clamp(first_pass_of(epoch) / 32, 1U, 8U);
    wishes.shares = settings.noisy_pixels;
    return wishes;
}

/// The passes by which it is measured what learning may cost: those of the epoch, or as many as the
/// error of a picture asks for.
std::uint64_t worth_learning(std::uint32_t epoch) {
    const std::uint64_t passes = first_pass_of(epoch + 1) - first_pass_of(epoch);
    return std::max(passes, kTargetRounds * kRoundPasses);
}

}  // namespace

std::uint32_t usual_paths(const PhotonSettings& settings, std::size_t pixels) {
    constexpr std::size_t kLeast = 200'000;
    constexpr std::size_t kOfPixel = 2;
    constexpr std::size_t kMost = std::size_t{1} << 30U;
    const std::size_t usual = std::min(kMost, std::max(kLeast, kOfPixel * pixels));
    return settings.paths_per_pass.value_or(static_cast<std::uint32_t>(usual));
}

bool needs_learning(const Scene& scene, const RenderSettings& settings) {
    return !scene.is_dark() && settings.integrator == Integrator::sppm &&
           settings.photon.sampler == PhotonSampler::adaptive;
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
        epoch.groups.push_back({scene.light_choice(), {paths, {}}, {}});
        return epoch;
    }
    const std::uint32_t first = first_pass_of(epoch.number);
    const PassScene at_wavelengths(scene, {settings.seed, first});
    const PilotName name{settings.seed, epoch.number};
    const EyePass eye{
        at_wavelengths, settings.transport,         settings.eye,
        window,         name.round(kSeenViewRound), radius_factor(first, settings.alpha)};
    watch.lap();
    const EyeView seen = view_of(eye);
    if (view_traced) view_traced(watch.lap());
    const PhotonView view{at_wavelengths, settings.transport, seen.index};
    const std::uint64_t work = worth_learning(epoch.number) * (paths + window.pixels());
    LightPlanner planner(view, settings.photon, name, work);
    epoch.groups = planner.plan(paths);
    const DrawWishes wishes = wishes_of(settings.photon, epoch.number, paths, window.pixels());
    DrawPlan plan = measured_plan(eye, seen, epoch.groups, name, wishes);
    epoch.doublings = std::move(plan.doublings);
    if (wishes.balance) {
        const Balance& balance = plan.balance;
        if (balance.paths > paths) epoch.groups = planner.plan(balance.paths);
        if (balance.paths < paths)
            epoch.groups = part_of(std::move(epoch.groups), paths / balance.paths);
        epoch.paths = static_cast<std::uint32_t>(paths_of(epoch.groups));
        epoch.draws = balance.draws;
        epoch.weight = settings.photon.pass_weights ? balance.weight : 1;
    }
    epoch.seconds = watch.seconds();
    return epoch;
}

}  // namespace sunfleck
