// `sunfleck scene`: writes one of our own scenes as pbrt-v4 files, or lists them.
#include "apps/cli/commands.h"
#include "apps/cli/scene_files.h"
#include "procedural/scenes.h"

#include <fmt/format.h>

#include <filesystem>

namespace sunfleck::engine {

int run_scene(const SceneOptions& options) {
    if (options.name.empty()) {
        for (const ProceduralScene& scene : procedural_scenes())
            fmt::print("{:<14} {}\n", scene.name, scene.what);
        return 0;
    }
    std::vector<ExportedFile> files;
    for (SceneFile& file : make_scene(options.name))
        files.push_back({std::move(file.name), [bytes = std::move(file.bytes)] { return bytes; }});
    write_scene_files(options.folder, files, options.force);
    fmt::print("{}\n", (std::filesystem::path(options.folder) / files.front().name).string());
    return 0;
}

}  // namespace sunfleck::engine
