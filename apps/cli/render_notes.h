// What a user is told of a render before it begins and of the picture at its end, line by line.
#pragma once

#include "apps/cli/render_setup.h"
#include "render/render_state.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// That pictures may differ from those of other machines.
std::vector<std::string> machine_warnings(const std::string& isa);

/// What may make the picture other than expected: the scene's warnings, the machine, the sampler.
std::vector<std::string> warnings_of(const RenderOptions& options, const Scene& scene);

/// Defaults that were taken, and that the user may want to know of.
std::vector<std::string> notes_of(const RenderSetup& setup);

/// What is doubtful in the picture: light that is missing, brightness that is uncertain.
std::vector<std::string> doubts_of(const RenderSetup& setup, const RenderResult& result);

}  // namespace sunfleck::engine
