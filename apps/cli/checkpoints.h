// Checkpoints of `sunfleck render`: tried before the work, written while it goes on.
#pragma once

#include "apps/cli/deferred_error.h"
#include "render/checkpoint.h"

namespace sunfleck::engine {

/// Tries --checkpoint and reads --resume, as far as they are given.
/// @throws Error if either cannot be used; also if --checkpoint would replace what is not resumed.
std::optional<Checkpoint> open_checkpoints(const RenderOptions& options);

/// Writes checkpoints. A fault is a warning at first: the render goes on, the former checkpoint
/// stays, and the next is tried.
class CheckpointKeeper {
public:
    explicit CheckpointKeeper(const RenderOptions& options)
        : options_(options), fault_(options.log) {}

    /// Not cut short by a second Ctrl-C.
    void save(const Origin& origin, const RenderState& state);
    /// @throws Error if the last one could not be written.
    void finish() const { fault_.finish(); }

private:
    const RenderOptions& options_;
    DeferredError fault_;  // of the last save
};

}  // namespace sunfleck::engine
