// The flags of `sunfleck render`: those of renders, and its own for files, threads and messages.
#pragma once

#include "apps/cli/options.h"
#include "flags/render_flags.h"

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// @param flags  takes the flags of renders.
void add_render_flags(CLI::App& app, RenderOptions& options, RenderFlags& flags);

/// To be called when all flags have been read. @throws Error naming a flag that cannot be used.
void finish_render(const CLI::App& given, const RenderFlags& flags, RenderOptions& options);

}  // namespace sunfleck::engine
