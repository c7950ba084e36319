// The flags of every command except `sunfleck render`, which has a file of its own.
#pragma once

#include "apps/cli/completion.h"
#include "apps/cli/options.h"
#include "flags/render_flags.h"

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// What the program says of itself.
struct ManualOptions {
    const Shell* shell = nullptr;
    std::string folder;
};

void add_info_flags(CLI::App& app, InfoOptions& options);
void add_scene_flags(CLI::App& app, SceneOptions& options);
void add_convert_flags(CLI::App& app, ConvertOptions& options);
/// @param flags  receives the flags that merge and relight share with renders.
void add_merge_flags(CLI::App& app, MergeOptions& options, RenderFlags& flags);
void add_relight_flags(CLI::App& app, RelightOptions& options, RenderFlags& flags);
void add_view_flags(CLI::App& app, ViewOptions& options, RenderFlags& flags);
void add_compare_flags(CLI::App& app, CompareOptions& options);
void add_experiment_flags(CLI::App& app, ExperimentOptions& options);
void add_completion_flags(CLI::App& app, ManualOptions& options);
void add_manual_flags(CLI::App& app, ManualOptions& options);

/// @throws Error for flags of `sunfleck experiment` that do not go together.
void check_experiment(const CLI::App& given);

}  // namespace sunfleck::engine
