// The flags of mattes: --cryptomatte, --cryptomatte-samples.
#pragma once

#include "apps/cli/options.h"

namespace CLI {
class App;
}

namespace sunfleck::engine {

void add_matte_flags(CLI::App& app, RenderOptions& o);

/// @throws Error for mattes that no output could hold.
void check_mattes(const RenderOptions& o);

}  // namespace sunfleck::engine
