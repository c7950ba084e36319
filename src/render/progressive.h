// Progressive rendering: passes until a limit is reached, summed in a film.
//
// In:  scene, settings, limits, and earlier passes to continue from. Out: the film. Only complete
// passes enter it, and nothing that depends on the clock: a time limit cancels the last pass, or
// the learning before it, and leaves it out. Several ranks render together, to the same bytes
// (ranks.h, reduction_interval.h).
#pragma once

#include "ranks/ranks.h"
#include "render/render_hooks.h"
#include "render/render_job.h"
#include "render/render_state.h"

#include <optional>

namespace sunfleck::engine {

/// @throws Error  for several ranks with a sampler whose passes depend on earlier ones.
void check_shareable(const RenderSettings& settings, const Ranks& ranks);

/// @param earlier  passes of this job to continue from, without gaps from the job's first pass: the
/// result is as if they were rendered now. Their seconds count.
/// @param ranks    all of them call this with the same job and limits. Rank 0's earlier passes and
/// hooks are used, and it has the result; others need `interrupted` alone.
/// @throws Error  as check_shareable().
RenderResult render(const RenderJob& job, const RenderHooks& hooks,
                    std::optional<RenderState> earlier = {}, const Ranks& ranks = {});

}  // namespace sunfleck::engine
