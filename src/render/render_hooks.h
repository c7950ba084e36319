// Callbacks of a render.
#pragma once

#include "film/target_error.h"
#include "image/picture.h"
#include "render/render_state.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace sunfleck::engine {

/// The state after a pass.
struct Progress {
    std::uint32_t passes = 0;  // rendered so far
    std::optional<std::uint32_t> of;
    double seconds = 0;
    double cpu_seconds = 0;            // of all threads
    std::optional<TargetError> error;  // from complete batches
    std::optional<double> target;
    std::optional<double> seconds_left;  // an estimate
    double bringing = 0;                 // fraction of photon paths that contributed light
    std::uint32_t starved = 0;           // passes without a visible photon path
    bool is_learning = false;            // an epoch is learned before the next pass
};

/// Calls what changes the film of a render: a caller who reads the film on another thread holds a
/// lock meanwhile.
using FilmChange = std::function<void(const std::function<void()>& change)>;

/// Changes the film by way of the caller's function, if there is one.
inline void change_film(const FilmChange& caller, const std::function<void()>& change) {
    if (caller)
        caller(change);
    else
        change();
}

struct RenderHooks {
    /// Called after each pass, or interval of several ranks, and before and after learning.
    std::function<void(const Progress&)> report;
    /// Called after 1, 2, 4, 8 ... passes and at the end; its time does not count.
    std::function<void(const RenderResult&)> snapshot;
    /// Called after each pass, or interval of several ranks, with all passes so far.
    std::function<void(const Film&)> watch;
    /// Called after each pass of a render by one machine, whose next pass waits for its return.
    /// Its time does not count. @return whether more passes are to follow.
    std::function<bool()> goes_on;
    /// Called while the first pass is planned, with a picture of fewer pixels: what light camera
    /// paths alone have found. Not where nothing is learned, nor by several ranks.
    std::function<void(Picture)> preview;
    /// Tested after each pass, and during the learning of later epochs.
    const std::atomic<bool>* interrupted = nullptr;
    /// Tested continuously: learning and the current pass are cancelled and left out. Passes of a
    /// sampler with a state are completed.
    const std::atomic<bool>* cancelled = nullptr;
    FilmChange change;

    bool is_cancelled() const { return cancelled != nullptr && *cancelled; }
    bool is_interrupted() const {
        return is_cancelled() || (interrupted != nullptr && *interrupted);
    }
    /// Called after a pass if `save_every` seconds have passed since the last call began, and at
    /// the end.
    std::function<void(const RenderState&)> save;
    double save_every = 60;
};

}  // namespace sunfleck::engine
