// The epoch of a pass: with nothing to learn, by one way, or by the better of two; after those
// before it.
#include "planning/learn_epoch.h"

#include "core/stopwatch.h"
#include "photon_samplers/samplers.h"
#include "planning/epoch_learner.h"
#include "planning/way_tuning.h"

namespace sunfleck::engine {
namespace {

/// Returns whether indirect light has less error by `sampled`, which is planned only where that may
/// be so.
/// @param photons  has its plan.
bool camera_is_better(EpochLearner& photons, EpochLearner& sampled, Objective objective) {
    WayTrials by_photons = photons.without_photons();
    WayTrials by_camera = sampled.without_photons();
    const auto camera_has_less_than = [&](double share) {
        return error_of_way(by_camera, by_photons, objective) <
               share * error_of_way(by_photons, by_camera, objective);
    };
    photons.add_photons(by_photons);
    // Without photons, `sampled` has a lower bound of its error alone.
    if (!camera_has_less_than(kHardlyBetter)) photons.add_photons(by_photons);
    if (!camera_has_less_than(kHardlyBetter)) return false;
    sampled.plan({{}, photons.boxes()});
    sampled.add_photons(by_camera);
    if (camera_has_less_than(kClearlyBetter)) return true;
    if (!camera_has_less_than(1 / kClearlyBetter)) return false;
    if (by_photons.sets == by_camera.sets) photons.add_photons(by_photons);
    sampled.add_photons(by_camera);
    return camera_has_less_than(1);
}

/// Returns the first epoch by the way `sampled`, or by the better one. In either case chains of the
/// way `photons` explore the scene, and trials of worth start where they have been.
/// @param for_small_passes  no other passes are to have it.
Epoch first_epoch(const PassScene& scene, const RenderSettings& settings, IndirectLight way,
                  const TrialTraced& trial_traced, bool for_small_passes) {
    const bool is_sampled = way == IndirectLight::sampled;
    EpochLearner photons(scene, settings, IndirectLight::photons, 0);
    photons.look(is_sampled ? nullptr : trial_traced);
    EpochLearner sampled(scene, settings, IndirectLight::sampled, 0);
    sampled.look(is_sampled ? trial_traced : nullptr);
    photons.plan();
    if (is_sampled) {
        sampled.plan({{}, photons.boxes()});
        return sampled.measured(for_small_passes);
    }
    const bool by_camera = camera_is_better(photons, sampled, settings.objective);
    return (by_camera ? sampled : photons).measured(for_small_passes);
}

/// Returns the way that the settings ask for.
IndirectLight way_of(const RenderSettings& settings) {
    const bool are_all = settings.transport.direct == DirectLight::photons;
    return are_all ? IndirectLight::photons : settings.transport.indirect;
}

bool is_small(const Scene& scene, const RenderSettings& settings, std::uint32_t pass) {
    return is_small_pass(settings, window_of(scene.film()).pixels(), pass);
}

/// Learns the epoch of a pass. @param before  one before it, if any is known.
Epoch learned_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                    const Epoch* before, const TrialTraced& trial_traced) {
    const std::uint32_t number = epoch_of(pass);
    const bool small = is_small(scene, settings, pass);
    IndirectLight way = way_of(settings);
    std::optional<Epoch> first;
    const bool aims = way == IndirectLight::sampled && settings.photon.emission_guide;
    if (!before && (aims || way == IndirectLight::automatic)) {
        first = first_epoch(PassScene(scene, {settings.seed, 0}), settings, way, trial_traced,
                            small || number > 0);
        if (number == 0) return *std::move(first);
        before = &*first;
    }
    if (before) way = before->transport.indirect;
    std::shared_ptr<const WorthRounds> worth = before ? before->worth : nullptr;
    // Rounds of worth go on from epoch to epoch; all else is learned for each.
    for (std::uint32_t next = worth ? before->number + 1 : number;; ++next) {
        const bool is_last = next == number;
        const PassScene at_wavelengths(scene, {settings.seed, first_pass_of(next)});
        EpochLearner learner(at_wavelengths, settings, way, next);
        learner.look(is_last ? trial_traced : nullptr);
        learner.plan({std::move(worth), {}});
        if (is_last) return learner.measured(small);
        worth = learner.worth();
    }
}

/// Returns an epoch for small passes, as it is for all of its passes.
Epoch epoch_for_all(const Scene& scene, const RenderSettings& settings, Epoch epoch) {
    const PassScene at_wavelengths(scene, {settings.seed, first_pass_of(epoch.number)});
    return EpochLearner(at_wavelengths, settings, epoch.transport.indirect, epoch.number)
        .measured_for_all(std::move(epoch));
}

/// Returns the epoch that needs no pilots, and no trials but one for edges.
Epoch usual_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t number) {
    const std::uint32_t paths = usual_paths(settings.photon, window_of(scene.film()).pixels());
    Epoch epoch{.number = number,
                .paths = paths,
                .transport = settings.transport,
                .log2_samples = {},
                .edges = {},
                .strata = {},
                .worth = {}};
    if (epoch.transport.indirect == IndirectLight::automatic)
        epoch.transport.indirect = IndirectLight::photons;
    if (scene.is_dark() && settings.integrator == Integrator::sppm)
        epoch.paths = 0;
    else
        epoch.strata.push_back({scene.light_choice(), {paths, {}}, {}});
    if (settings.integrator == Integrator::sppm && settings.camera.edges && !scene.is_dark()) {
        const PassScene at_wavelengths(scene, {settings.seed, first_pass_of(number)});
        EpochLearner learner(at_wavelengths, settings, epoch.transport.indirect, number);
        epoch.edges = learner.edges();
    }
    return epoch;
}

}  // namespace

bool needs_learning(const Scene& scene, const RenderSettings& settings) {
    return !scene.is_dark() && settings.integrator == Integrator::sppm &&
           learns(settings.photon.sampler) &&
           usual_paths(settings.photon, window_of(scene.film()).pixels()) >= 2;
}

Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                  const TrialTraced& trial_traced, const Epoch* before) {
    const std::uint32_t number = epoch_of(pass);
    Stopwatch watch;
    const bool is_begun =
        before && before->number == number && !serves(*before, scene, settings, pass);
    if (before && before->number >= number && !is_begun) before = nullptr;
    Epoch epoch;
    if (is_begun)
        epoch = epoch_for_all(scene, settings, *before);
    else if (needs_learning(scene, settings))
        epoch = learned_epoch(scene, settings, pass, before, trial_traced);
    else
        epoch = usual_epoch(scene, settings, number);
    epoch.seconds = watch.seconds();
    return epoch;
}

bool serves(const Epoch& epoch, const Scene& scene, const RenderSettings& settings,
            std::uint32_t pass) {
    return epoch.number == epoch_of(pass) &&
           (!epoch.is_for_small_passes || is_small(scene, settings, pass));
}

}  // namespace sunfleck::engine
