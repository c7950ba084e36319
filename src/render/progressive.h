// A whole render: passes one after the other until a limit, added up in a film.
//
// In:  scene, settings, limits, and earlier passes to go on from. Out: the film. Only whole passes
// go into it, and never what depends on the clock: a limit of time cuts the last pass short, or the
// learning before it, and leaves it out. Several ranks render it together, to the same bytes
// (ranks.h, reduction_interval.h).
#pragma once

#include "ranks/ranks.h"
#include "render/render_hooks.h"
#include "render/render_job.h"
#include "render/render_state.h"

#include <optional>

namespace sunfleck::engine {

/// @throws Error for several ranks and a sampler whose passes build on those before.
void check_shareable(const RenderSettings& settings, const Ranks& ranks);

/// @param earlier  passes of this job to go on from, the job's first pass to some other without a
///                 gap: the result is as if they were rendered now. Their seconds count.
/// @param ranks    all of them call this with one job and the same limits. Rank 0's earlier passes
///                 and hooks count, and it has the result; others need `interrupted` alone.
/// @throws Error as check_shareable() does.
RenderResult render(const RenderJob& job, const RenderHooks& hooks,
                    std::optional<RenderState> earlier = {}, const Ranks& ranks = {});

}  // namespace sunfleck::engine
