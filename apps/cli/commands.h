// The commands of the program, one function each. All throw Error for bad input.
#pragma once

#include "apps/cli/options.h"
#include "ranks/ranks.h"

namespace sunfleck::engine {

/// Renders, together with all other ranks; rank 0 writes the outputs.
/// @return 0, or on rank 0 130 when interrupted.
/// @throws FaultOfAll as together() does.
int run_render(const RenderOptions& asked, const Ranks& ranks);
/// Prints what was read, what is approximated, lights, bounds and triangles.
int run_info(const InfoOptions& options);
/// Writes one of Sunfleck's own scenes, or lists them.
int run_scene(const SceneOptions& options);
/// Writes a scene as a pbrt-v4 scene.
int run_convert(const ConvertOptions& options);
/// Makes figures and tables of the paper, or lists them. @return 0, or 130 when interrupted.
int run_experiment(const ExperimentOptions& options);
/// Adds up pass ranges of one render.
int run_merge(const MergeOptions& options);
/// Dims or brightens the lights of a picture whose AOVs hold them apart.
int run_relight(const RelightOptions& options);
/// Shows a picture in a browser, until Ctrl+C.
int run_view(const ViewOptions& options);
/// Measures pictures against a reference, and writes the page that shows them.
int run_compare(const CompareOptions& options);

}  // namespace sunfleck::engine
