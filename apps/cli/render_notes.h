// Defaults of a render that its user is told of before it begins, line by line.
#pragma once

#include "apps/cli/render_setup.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Defaults that were taken, and that the user may want to know of.
std::vector<std::string> notes_of(const RenderSetup& setup);

}  // namespace sunfleck::engine
