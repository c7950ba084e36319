// Checkpoint files of `sunfleck render`: checked before the render begins, written while it runs.
#pragma once

#include "apps/cli/deferred_error.h"
#include "render/checkpoint.h"

namespace sunfleck::engine {

/// Checks that --checkpoint can be written, and reads --resume, where they are given.
/// @throws Error if either cannot be used, or if --checkpoint would replace another checkpoint than
///         the one that is resumed.
std::optional<Checkpoint> open_checkpoints(const RenderOptions& options);

/// Writes checkpoints. A fault is a warning at first: the render goes on, the former checkpoint
/// stays, and the next is tried.
class CheckpointKeeper {
public:
    explicit CheckpointKeeper(const RenderOptions& options)
        : options_(options), fault_(options.log) {}

    /// Writes a checkpoint to its end, also after a second Ctrl-C.
    void save(const Origin& origin, const RenderState& state);
    /// @throws Error if the last one could not be written.
    void finish() const { fault_.finish(); }

private:
    const RenderOptions& options_;
    DeferredError fault_;  // of the last save
};

}  // namespace sunfleck::engine
