// A pilot or a guide by worth, then trials, for visible points like those of the epoch's first
// pass.
#include "planning/epoch_learner.h"

#include "camera_paths/edge_tuning.h"
#include "core/stopwatch.h"
#include "film/target_error.h"
#include "math/wavelengths.h"
#include "photon/light_strata.h"
#include "photon_samplers/samplers.h"
#include "planning/direct_in_media_trial.h"
#include "planning/edge_pixels.h"
#include "planning/pixel_allocation.h"
#include "planning/remainder_scales.h"
#include "planning/trial_iterations.h"
#include "planning/way_tuning.h"
#include "visible_points/radius.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the side of the cells of the trial that planners explore, each with one path: it costs
/// no more in large pictures than in small ones. All epochs have the same, for they share trials of
/// worth.
int trial_cells(std::size_t pixels) {
    return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(pixels) / kPathsOfATrial)));
}

/// The first epoch is too short for trials as large as those of others, and its trials cost no more
/// in large pictures than in small ones. Long epochs can pay for more.
/// @param paths  photon paths of a pass.
AllocationRequest request_of(Objective objective, std::uint32_t epoch, std::size_t pixels,
                             std::uint32_t paths) {
    AllocationRequest request{
        .objective = objective, .pixels = {}, .cells = pixels > kLargePicture ? 2 : 1};
    if (epoch == 0) {
        request.cells = std::max(2, trial_cells(pixels));
        request.pixels.cells = std::max(kCellsOfFirstTrials, request.cells);
        request.parts = std::max(kPartsOfFirstPhotons, paths / kMostPathsOfAFirstSet);
    }
    request.pixels.pairs_of_nets =
        std::clamp(first_pass_of(epoch) / kPassesOfAPairOfNets, 1U, kMostPairsOfNets);
    return request;
}

/// The passes by which it is measured what learning may cost: those of the epoch, or as many as the
/// error of a picture asks for.
std::uint64_t worth_learning(std::uint32_t epoch) {
    return std::max<std::uint64_t>(passes_of_epoch(epoch), kTargetBatches * kBatchPasses);
}

/// All lights in one stratum. @param by_worth  a plan of full support: if its map is the identity,
/// paths are uniform. @param scales  of the chains that bring what its bounded weights leave.
std::vector<LightStratum> in_one_stratum(const LightChoice& lights, const GuidedPlan& by_worth,
                                         const MutationScales& scales, std::uint32_t paths) {
    if (by_worth.map.is_identity()) return {{lights, {paths, {}}, {}}};
    LightStratum stratum{lights, {}, by_worth};
    const std::uint32_t states = by_worth.most_weight < kUnbounded ? paths / kPathsOfAState : 0;
    stratum.guided.paths = paths - states;
    if (states > 0)
        stratum.plan.levels = {
            {kVisible, states, std::max(1U, states / kStatesOfARemainderChain), scales}};
    return {stratum};
}

}  // namespace

EpochLearner::EpochLearner(const PassScene& scene, const RenderSettings& settings,
                           IndirectLight way, std::uint32_t epoch)
    : settings_(settings),
      epoch_{.number = epoch,
             .transport = settings.transport,
             .log2_samples = {},
             .edges = {},
             .strata = {},
             .worth = {}},
      name_{settings.seed, epoch},
      pass_{scene,
            epoch_.transport,
            settings.camera,
            window_of(scene.scene.film()),
            name_.iteration(kExploredTrialIteration),
            radius_factor(first_pass_of(epoch), settings.alpha)},
      trial_(pass_) {
    epoch_.transport.indirect = way;
    if (may_share_direct_light(scene, epoch_.transport)) trial_.direct_in_media.emplace();
    trial_.cells = trial_cells(trial_.window.pixels());
    trial_.radius_factor *= trial_.cells;
}

void EpochLearner::look(const TrialTraced& trial_traced) {
    Stopwatch watch;
    seen_.emplace(view_of(trial_));
    if (trial_traced) trial_traced(watch.lap() * pixels_of_a_path(trial_.cells), *seen_);
    context_.emplace(PhotonContext{trial_.scene, epoch_.transport, seen_->index});
    if (trial_.cells > 1) return;
    epoch_.edges = edges();
    trial_.edges = epoch_.edges;
}

void EpochLearner::plan(WorthStart start) {
    epoch_.paths = usual_paths(settings_.photon, pass_.window.pixels());
    epoch_.strata = epoch_.transport.goes_beyond_diffuse()
                        ? planned_independent_paths(std::move(start))
                        : planned_chains();
}

std::vector<LightStratum> EpochLearner::planned_chains() {
    const std::uint64_t work = worth_learning(name_.epoch) * (epoch_.paths + pass_.window.pixels());
    return LightPlanner(*context_, settings_.photon, name_, work).plan(epoch_.paths);
}

std::vector<LightStratum> EpochLearner::planned_independent_paths(WorthStart start) {
    const LightChoice& lights = context_->scene.scene.light_choice();
    WorthGuide guide;
    MutationScales scales;
    if (settings_.photon.emission_guide) {
        guide = learned_worth_guide(*context_, pass_.window, *seen_, name_,
                                    {epoch_.paths, settings_.objective, std::move(start)});
        epoch_.worth = guide.rounds;
        const bool bends_nothing = guide.plan.map.is_identity();
        if (bends_nothing && !settings_.photon.paths_per_pass)
            epoch_.paths = std::min(epoch_.paths, kFewPaths);
        if (!guide.bounded.empty())
            scales = remainder_scales(*context_, lights, guide.plan, guide.bounded, name_);
    }
    return in_one_stratum(lights, guide.plan, scales, epoch_.paths);
}

EdgePixels EpochLearner::edges() const {
    if (!settings_.camera.edges) return {};
    if (seen_ && trial_.cells == 1) return edge_pixels(*seen_, pass_.window);
    TransportSettings transport = epoch_.transport;
    transport.indirect = IndirectLight::photons;  // camera paths that end at their discs
    CameraPass pass{pass_.scene,  transport, pass_.settings,
                    pass_.window, pass_.id,  pass_.radius_factor};
    pass.cells = trial_.cells > 1 ? kCellsOfEdges : 1;
    return edge_pixels(view_of(pass), pass_.window);
}

Epoch EpochLearner::measured(bool for_small_passes) {
    if (trial_.cells > 1) epoch_.edges = edges();
    if (trial_.direct_in_media)
        epoch_.direct_in_media = learned_direct_in_media(trial_, *seen_, epoch_.strata, name_);
    epoch_.is_for_small_passes = settings_.photon.adaptive_pixels && for_small_passes;
    if (settings_.photon.adaptive_pixels && !for_small_passes) allocate_pixels();
    return std::move(epoch_);
}

Epoch EpochLearner::measured_for_all(Epoch epoch) {
    epoch_ = std::move(epoch);
    if (trial_.cells == 1) look({});
    epoch_.is_for_small_passes = false;
    allocate_pixels();
    return std::move(epoch_);
}

void EpochLearner::allocate_pixels() {
    const AllocationRequest request =
        request_of(settings_.objective, epoch_.number, pass_.window.pixels(), epoch_.paths);
    if (epoch_.paths < 2 * request.parts) return;
    // Noise is that of discs as narrow as those of passes.
    CameraPass first = pass_;
    first.edges = epoch_.edges;
    first.direct_in_media = epoch_.direct_in_media;
    std::optional<CameraTrial> narrow;
    if (trial_.cells > 1) {
        first.cells = request.cells;
        narrow.emplace(view_of(first));
    }
    epoch_.log2_samples =
        chosen_allocation(first, narrow ? *narrow : *seen_, epoch_.strata, name_, request);
}

}  // namespace sunfleck::engine
