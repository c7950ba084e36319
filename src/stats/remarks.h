// Remarks of a render: warnings, a line each, about what may make the picture unexpected.
#pragma once

#include "render/render_job.h"
#include "render/render_state.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns a warning if pictures may differ from those of other machines.
/// @param isa  that the scene was built with.
std::vector<std::string> machine_warnings(const std::string& isa);

/// Returns the remarks known before the render: the scene's warnings, machine_warnings(), bias.
std::vector<std::string> remarks_before(const RenderJob& job, const std::string& isa);

/// Returns the remarks about the picture: missing light, unknown errors, too short a time.
std::vector<std::string> remarks_after(const RenderJob& job, const RenderResult& result);

}  // namespace sunfleck::engine
