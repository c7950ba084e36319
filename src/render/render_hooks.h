// What a render asks of its caller, and tells it, while it runs.
#pragma once

#include "film/target_error.h"
#include "render/render_state.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace sunfleck::engine {

/// What is known after a pass.
struct Progress {
    std::uint32_t passes = 0;  // rendered so far
    std::optional<std::uint32_t> of;
    double seconds = 0;
    double cpu_seconds = 0;            // of all threads
    std::optional<TargetError> error;  // from complete batches
    std::optional<double> target;
    std::optional<double> seconds_left;  // an estimate
    double bringing = 0;                 // share of photon paths that brought light
    std::uint32_t starved = 0;           // passes that found no visible photon path
    bool is_learning = false;            // where photons are needed, before the next pass
};

struct RenderHooks {
    /// After each pass, or interval of several ranks, and before and after an epoch is learned.
    std::function<void(const Progress&)> report;
    /// After 1, 2, 4, 8 ... passes and at the end; its time does not count.
    std::function<void(const RenderResult&)> snapshot;
    /// Asked after each pass, and while epochs are learned but the first.
    const std::atomic<bool>* interrupted = nullptr;
    /// After a pass when `save_every` seconds have gone since the last call began, and at the end.
    std::function<void(const RenderState&)> save;
    double save_every = 60;
};

}  // namespace sunfleck::engine
