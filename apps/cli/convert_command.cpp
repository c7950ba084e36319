// `sunfleck convert`: writes any scene that is read as a pbrt-v4 scene.
#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "apps/cli/scene_files.h"
#include "export/pbrt_scene.h"
#include "import/load.h"

#include <fmt/format.h>

namespace sunfleck::engine {

int run_convert(const ConvertOptions& options) {
    const std::filesystem::path output = options.output;
    const SceneDescription scene = load_scene(options.scene, options.scene_request);
    const ExportedScene exported = pbrt_scene(scene, output.filename().string());
    write_scene_files(output.parent_path(), exported.files, options.force);
    for (const Warnings* all : {&scene.warnings, &exported.warnings})
        for (const Warnings::Entry& warning : all->entries()) say(warning.line());
    fmt::print("{}\n", output.string());
    return 0;
}

}  // namespace sunfleck::engine
