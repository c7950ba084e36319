// What is to be said of a render beside its picture: a line for each thing that may make the
// picture other than expected.
#pragma once

#include "render/render_job.h"
#include "render/render_state.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Says that pictures may differ from those of other machines, if that is so.
/// @param isa  that the scene was built with.
std::vector<std::string> machine_warnings(const std::string& isa);

/// Returns what is known before the render: warnings of the scene, bytes that may differ, bias.
std::vector<std::string> remarks_before(const RenderJob& job, const std::string& isa);

/// Returns what the picture tells: light that is missing, errors that are not known, time that was
/// too short.
std::vector<std::string> remarks_after(const RenderJob& job, const RenderResult& result);

}  // namespace sunfleck::engine
