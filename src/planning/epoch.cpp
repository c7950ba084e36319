// Learning of an epoch by a pilot and trials for visible points like those of its first pass.
#include "planning/epoch.h"

#include "core/stopwatch.h"
#include "film/target_error.h"
#include "math/wavelengths.h"
#include "photon/light_strata.h"
#include "photon_samplers/samplers.h"
#include "planning/photon_budget.h"
#include "planning/trial_iterations.h"
#include "planning/worth_guide.h"
#include "visible_points/radius.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Photon paths where nothing in the scene bends light, so that they bring nothing.
constexpr std::uint32_t kFewPaths = 1024;

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
    request.trials.pairs_of_nets = std::clamp(first_pass_of(epoch) / 32, 1U, 8U);
    request.shares = settings.adaptive_pixels;
    return request;
}

/// The passes by which it is measured what learning may cost: those of the epoch, or as many as the
/// error of a picture asks for.
std::uint64_t worth_learning(std::uint32_t epoch) {
    const std::uint64_t passes = first_pass_of(epoch + 1) - first_pass_of(epoch);
    return std::max(passes, kTargetBatches * kBatchPasses);
}

/// How photon paths of an epoch are chosen.
struct PathPlanner {
    std::function<std::vector<LightStratum>(std::uint32_t)> plan;  // of so many paths
    std::uint32_t paths = 0;                                       // of a usual subpass
};

/// All lights in one stratum. @param guide  of full support; the identity: uniform paths.
std::vector<LightStratum> in_one_stratum(const LightChoice& lights, const EmissionGuide& guide,
                                         std::uint32_t paths) {
    LightStratum stratum{lights, {}, {}};
    if (guide.is_identity())
        stratum.plan.uniform_paths = paths;
    else
        stratum.guided = {guide, paths, 1, 1};
    return {stratum};
}

/// @param context  must outlive the result.
PathPlanner planner_of(const PhotonContext& context, const RenderSettings& settings,
                       const PixelWindow& window, const CameraTrial& seen, const PilotName& name) {
    const PhotonSettings& photon = settings.photon;
    const std::uint32_t paths = usual_paths(photon, window.pixels());
    if (!context.transport.goes_beyond_diffuse()) {
        const std::uint64_t work = worth_learning(name.epoch) * (paths + window.pixels());
        auto planner = std::make_shared<LightPlanner>(context, photon, name, work);
        return {[planner](std::uint32_t count) { return planner->plan(count); }, paths};
    }
    EmissionGuide guide;
    if (photon.emission_guide) guide = learned_worth_guide(context, window, seen, name);
    const bool bends_nothing = photon.emission_guide && guide.is_identity();
    const LightChoice& lights = context.scene.scene.light_choice();
    return {[&lights, guide](std::uint32_t count) { return in_one_stratum(lights, guide, count); },
            bends_nothing && !photon.paths_per_pass ? std::min(paths, kFewPaths) : paths};
}

}  // namespace

bool needs_learning(const Scene& scene, const RenderSettings& settings) {
    return !scene.is_dark() && settings.integrator == Integrator::sppm &&
           learns(settings.photon.sampler);
}

Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                  const std::function<void(double)>& trial_traced) {
    Stopwatch watch;
    const PixelWindow window = window_of(scene.film());
    Epoch epoch{.number = epoch_of(pass),
                .paths = usual_paths(settings.photon, window.pixels()),
                .log2_samples = {},
                .strata = {}};
    if (scene.is_dark() && settings.integrator == Integrator::sppm) {
        epoch.paths = 0;
        return epoch;
    }
    if (!needs_learning(scene, settings) || epoch.paths < 2) {
        epoch.strata.push_back({scene.light_choice(), {epoch.paths, {}}, {}});
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
    if (trial_traced) trial_traced(watch.lap());
    const PhotonContext photon_context{at_wavelengths, settings.transport, seen.index};
    const PathPlanner planner = planner_of(photon_context, settings, window, seen, name);
    const std::uint32_t paths = epoch.paths = planner.paths;
    epoch.strata = planner.plan(paths);
    const SubpassRequest request =
        request_of(settings.photon, epoch.number, paths, window.pixels());
    SubpassPlan plan = measured_plan(camera, seen, epoch.strata, name, request);
    epoch.log2_samples = std::move(plan.log2_samples);
    if (request.budget) {
        const PhotonBudget& budget = plan.budget;
        if (budget.paths > paths) epoch.strata = planner.plan(budget.paths);
        if (budget.paths < paths)
            epoch.strata = fraction_of(std::move(epoch.strata), paths / budget.paths);
        epoch.paths = static_cast<std::uint32_t>(paths_of(epoch.strata));
        epoch.subpasses = budget.subpasses;
        epoch.weight = settings.photon.pass_weights ? budget.weight : 1;
    }
    epoch.seconds = watch.seconds();
    return epoch;
}

}  // namespace sunfleck::engine
