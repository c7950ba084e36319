// `sunfleck scene`: writes one of our own scenes as pbrt-v4 files, or lists them.
#include "apps/cli/commands.h"
#include "image/atomic_file.h"
#include "image/read_file.h"
#include "procedural/scenes.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <filesystem>

namespace sunfleck::engine {

namespace {

namespace fs = std::filesystem;

bool is_written(const fs::path& path, const SceneFile& file) {
    std::error_code code;
    return fs::exists(path, code) && read_file(path.string()) == file.bytes;
}

/// @throws Error if another file stands where one is to be written.
void check_replaces_nothing(const fs::path& folder, const std::vector<SceneFile>& files) {
    for (const SceneFile& file : files) {
        const fs::path path = folder / file.name;
        std::error_code code;
        if (fs::exists(path, code) && !is_written(path, file))
            throw Error({path.string()}, "this file exists, and differs from the one to be written",
                        "give another folder with -o, or replace it with --force");
    }
}

}  // namespace

int run_scene(const SceneOptions& options) {
    if (options.name.empty()) {
        for (const ProceduralScene& scene : procedural_scenes())
            fmt::print("{:<14} {}\n", scene.name, scene.what);
        return 0;
    }
    const std::vector<SceneFile> files = make_scene(options.name);
    if (!options.force) check_replaces_nothing(options.folder, files);
    for (const SceneFile& file : files) {
        const fs::path path = fs::path(options.folder) / file.name;
        std::error_code fault;
        fs::create_directories(path.parent_path(), fault);
        if (fault)
            throw Error({path.parent_path().string()},
                        "cannot make this folder: " + fault.message(),
                        "give another folder with -o");
        if (options.force || !is_written(path, file)) write_file(path.string(), file.bytes);
    }
    fmt::print("{}\n", (fs::path(options.folder) / files.front().name).string());
    return 0;
}

}  // namespace sunfleck::engine
