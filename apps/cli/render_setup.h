// Preparation of a render: checks its files, reads the scene, and determines the settings.
#pragma once

#include "apps/cli/checkpoints.h"
#include "apps/cli/options.h"
#include "ranks/ranks.h"
#include "render/render_job.h"

#include <memory>

namespace sunfleck::engine {

/// A render that is ready to begin.
struct RenderSetup {
    RenderSetup(const RenderOptions& from, SceneDescription description);

    RenderOptions options;
    std::optional<Checkpoint> checkpoint;  // to continue
    std::vector<std::string> outputs;
    Origin origin;
    Scene scene;
    RenderJob job;  // of that scene, so do not copy
};

/// Returns the options of this rank: only rank 0 writes files and messages.
RenderOptions options_of(const RenderOptions& options, const Ranks& ranks);

/// Returns the files that this rank writes.
std::vector<std::string> written_files(const RenderSetup& setup);

/// @param options  of this rank.
/// @throws Error for whatever cannot be used.
std::unique_ptr<RenderSetup> prepare(const RenderOptions& options, const Ranks& ranks);

}  // namespace sunfleck::engine
