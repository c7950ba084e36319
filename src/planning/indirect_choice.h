// Who brings indirect light: trials of photons and of camera paths that go on, and their errors.
//
// In:  visible points and a plan of each way. Out: its error at equal work, by which the better way
// is chosen. The error is what a picture is judged by (aovs/objective.h). Trials are no part of a
// picture.
// Equations: docs/method/sampling.md, eqs. (40) and (41).
#pragma once

#include "aovs/objective.h"
#include "planning/photon_trials.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// What the camera paths of a pass bring, or its photon paths.
struct Brought {
    std::vector<double> light;     // mean of a pixel, by block
    std::vector<double> variance;  // of that mean, in one pass
    double work = 0;               // of a pass, in rays
    double passes = 0;             // as many have as many paths as all trials together
};

/// Trials of one way.
struct WayTrials {
    Brought camera;
    Brought photons;           // empty if none were tried
    std::uint32_t sets = 0;    // of photons
    bool goes_beyond = false;  // whether camera paths bring indirect light

    /// Returns the mean of a pixel.
    double light(std::size_t block) const {
        return camera.light[block] + (sets > 0 ? photons.light[block] : 0);
    }
    /// Returns the variance of light().
    double variance(std::size_t block) const {
        return camera.variance[block] / camera.passes +
               (sets > 0 ? photons.variance[block] / photons.passes : 0);
    }
    /// Returns the passes that have missed what was not found, by the paths that have the most.
    double passes() const {
        if (sets == 0) return 0;  // photons may bring it
        return goes_beyond ? std::max(camera.passes, photons.passes) : photons.passes;
    }
    std::size_t blocks() const { return camera.light.size(); }
};

/// Returns trials without photons. @param camera  a pass like the epoch's first, or with fewer
/// paths.
/// @param seen  its trial.
WayTrials camera_trials(const CameraPass& camera, const CameraTrial& seen, const PilotName& name);

/// Adds kWaySets sets of photons. @param plan  of a pass.
void add_photon_trials(const CameraPass& camera, const CameraTrial& seen,
                       const std::vector<LightStratum>& plan, const PilotName& name,
                       WayTrials& trials);

/// Returns the error of one way after a unit of work, split between camera and photon paths as is
/// best. Light that the other way found, and this one did not, counts as noise. Without photons, a
/// lower bound.
double error_of_way(const WayTrials& one, const WayTrials& other, Objective objective);

}  // namespace sunfleck::engine
