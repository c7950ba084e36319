// A whole render: passes one after the other until a limit, added up in a film.
//
// In:  scene, settings, limits. Out: the film. Between passes nothing is carried but the film's
// sums: a pass that runs is always finished.
#pragma once

#include "film/film.h"
#include "render/pass.h"

#include <atomic>
#include <functional>
#include <optional>

namespace sunfleck {

/// What is known after a pass.
struct Progress {
    std::uint32_t passes = 0;  // rendered so far
    std::optional<std::uint32_t> of;
    double seconds = 0;
    double paths_per_second = 0;  // photon paths (camera paths of the reference)
    std::optional<double> error;  // as the target error is meant; from complete rounds
    std::optional<double> target;
    std::optional<double> seconds_left;  // an estimate
    double visible_fraction = 0;         // mean over passes
    std::size_t levels = 0;              // of the last pass's ladder
    double acceptance = 0;               // of its mutations
    std::uint32_t starved = 0;           // passes that found no visible photon path
};

struct RenderResult {
    Film film;
    PassTimes seconds;
    double total_seconds = 0;
    std::uint32_t passes = 0;
    double radius_factor = 1;  // of the last pass
    bool interrupted = false;
};

struct RenderHooks {
    std::function<void(const Progress&)> report;  // after each pass
    /// After 1, 2, 4, 8 ... passes and at the end; its time does not count.
    std::function<void(const RenderResult&)> snapshot;
    const std::atomic<bool>* interrupted = nullptr;  // asked after each pass
};

/// What a render is to be compared by: scene_hash is of all that the scene's files hold.
struct RenderJob {
    const Scene& scene;
    RenderSettings settings;
    StopSettings stop;
    std::uint64_t scene_hash = 0;
};

RenderResult render(const RenderJob& job, const RenderHooks& hooks);

}  // namespace sunfleck
