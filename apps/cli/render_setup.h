// What comes before the first pass: files are tried, the scene is read, settings are put together.
#pragma once

#include "apps/cli/checkpoints.h"
#include "apps/cli/options.h"
#include "render/render_job.h"

#include <memory>

namespace sunfleck::engine {

/// A render that can begin.
struct RenderSetup {
    RenderSetup(const RenderOptions& from, SceneDescription description);

    RenderOptions options;
    std::optional<Checkpoint> checkpoint;  // to go on from
    std::vector<std::string> outputs;
    Origin origin;
    Scene scene;
    RenderJob job;  // of that scene, so do not copy
};

/// What is asked of this rank: rank 0 alone writes and speaks.
RenderOptions options_of(const RenderOptions& options, const Ranks& ranks);

/// The files that this rank writes.
std::vector<std::string> written_files(const RenderSetup& setup);

/// @param options  of this rank.
/// @throws Error for whatever cannot be used.
std::unique_ptr<RenderSetup> prepare(const RenderOptions& options, const Ranks& ranks);

}  // namespace sunfleck::engine
