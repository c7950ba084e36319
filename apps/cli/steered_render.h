// A render on one machine that viewers steer: they pause it, change when it ends, and look at
// regions and by other cameras while it waits. Its picture has the same bytes as without them.
#pragma once

#include "apps/cli/live_view.h"
#include "render/render_hooks.h"

#include <optional>

namespace sunfleck::engine {

/// @param setup  receives the ends that viewers have chosen.
/// @param hooks  of the render; viewers' wishes are added.
RenderResult render_steered(RenderSetup& setup, RenderHooks hooks,
                            std::optional<RenderState> earlier, LiveView& view);

/// Renders what viewers look at aside, until they have seen enough or a signal comes.
void look_aside(const RenderSetup& setup, LiveView& view);

}  // namespace sunfleck::engine
