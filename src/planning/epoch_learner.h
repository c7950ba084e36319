// EpochLearner: learns an epoch where one way brings indirect light, step by step.
//
// In:  scene, settings, the way. Out: trials of the way, and the epoch.
#pragma once

#include "planning/epoch.h"
#include "planning/indirect_choice.h"
#include "planning/worth_guide.h"
#include "stages/settings.h"

#include <functional>
#include <optional>

namespace sunfleck::engine {

class EpochLearner {
public:
    /// @param scene  at the wavelengths of the epoch's first pass; must outlive this, as must
    ///               `settings`.
    EpochLearner(const PassScene& scene, const RenderSettings& settings, IndirectLight way,
                 std::uint32_t epoch);
    EpochLearner(const EpochLearner&) = delete;
    EpochLearner(EpochLearner&&) = delete;
    EpochLearner& operator=(const EpochLearner&) = delete;
    EpochLearner& operator=(EpochLearner&&) = delete;
    ~EpochLearner() = default;

    /// Traces visible points, few in a large picture. @param trial_traced  see learn_epoch().
    void look(const TrialTraced& trial_traced);
    /// Learns where photon paths start, after look(). @param start  of trials of worth: boxes() of
    /// the way `photons`, or Epoch::worth of the epoch before.
    void plan(WorthStart start = {});
    /// Measures which pixels need more camera paths, after plan(), but for small passes, which do
    /// not ask. @return the epoch, which this no longer has.
    Epoch measured(bool for_small_passes = false);
    /// Returns an epoch of this number with what was not measured for small passes. Nothing else
    /// need be called before.
    Epoch measured_for_all(Epoch epoch);
    /// Returns where discs are probed.
    EdgePixels edges() const;

    /// After plan(): where chains have found visible paths of all lights; the identity if uniform
    /// paths are visible often, or strata have guides of their own.
    EmissionGuide boxes() const {
        return epoch_.strata.size() == 1 ? epoch_.strata.front().guided.map : EmissionGuide();
    }
    /// After plan().
    const std::shared_ptr<const WorthRounds>& worth() const { return epoch_.worth; }
    WayTrials without_photons() const { return camera_trials(trial_, *seen_, name_); }
    /// After plan().
    void add_photons(WayTrials& trials) const {
        add_photon_trials(trial_, *seen_, epoch_.strata, name_, trials);
    }

private:
    std::vector<LightStratum> planned_chains();
    std::vector<LightStratum> planned_independent_paths(WorthStart start);
    void allocate_pixels();

    const RenderSettings& settings_;
    Epoch epoch_;
    PilotName name_;
    CameraPass pass_;   // like the epoch's
    CameraPass trial_;  // what planners explore
    std::optional<CameraTrial> seen_;
    std::optional<PhotonContext> context_;
};

}  // namespace sunfleck::engine
