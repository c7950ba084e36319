// `sunfleck scene`: writes one of our own scenes as pbrt-v4 files, or lists them.
#include "apps/cli/commands.h"
#include "core/error.h"
#include "image/atomic_file.h"
#include "procedural/scenes.h"

#include <fmt/format.h>

#include <filesystem>

namespace sunfleck {

int run_scene(const SceneOptions& options) {
    if (options.name.empty()) {
        for (const ProceduralScene& scene : procedural_scenes())
            fmt::print("{:<14} {}\n", scene.name, scene.what);
        return 0;
    }
    const std::vector<SceneFile> files = make_scene(options.name);
    for (const SceneFile& file : files) {
        const std::filesystem::path path = std::filesystem::path(options.folder) / file.name;
        std::error_code fault;
        std::filesystem::create_directories(path.parent_path(), fault);
        if (fault)
            throw Error({path.parent_path().string()},
                        "cannot make this folder: " + fault.message(),
                        "give another folder with -o");
        write_file(path.string(), file.bytes);
    }
    fmt::print("{}\n", (std::filesystem::path(options.folder) / files.front().name).string());
    return 0;
}

}  // namespace sunfleck
