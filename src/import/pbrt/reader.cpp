// Reading from the first statement to the finished scene.
#include "import/pbrt/reader.h"

#include "core/file_content.h"
#include "import/pbrt/directives.h"
#include "import/pbrt/finish.h"
#include "import/pbrt/reading.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

/// Where the text of the main file comes from.
enum class Main { file, memory };

SceneDescription read_all(std::string text, const std::string& path, const FileAccess& files,
                          Main main, const ImportSettings& settings) {
    refuse_other_content(text, path, "a scene of pbrt-v4");
    Reading reading(path, files);
    reading.assets.subsurface = settings.subsurface;
    if (main == Main::file) reading.assets.files.list(path);
    TokenStream tokens;
    tokens.push(std::move(text), std::filesystem::path(path).lexically_normal().string(), {path});
    try {
        read_statements(reading, tokens);
    } catch (const Error&) {
        reading.assets.files.check_missing();  // the fault may be a consequence of missing files
        throw;
    }
    return finish_scene(reading);
}

}  // namespace

SceneDescription read_pbrt(const std::string& path, const ImportSettings& settings) {
    const FileAccess files = disk_access();
    return read_all(files(path, {path}), path, files, Main::file, settings);
}

SceneDescription read_pbrt_input(const ImportSettings& settings) {
    const std::string name(kStandardInput);
    const std::string text = unpacked(read_standard_input(name), name);
    SceneDescription scene = read_all(text, name, disk_access(), Main::file, settings);
    scene.text = text;
    return scene;
}

SceneDescription read_pbrt_text(const std::string& text, const std::string& path) {
    return read_all(text, path, disk_access(), Main::memory, {});
}

SceneDescription read_pbrt_text(const std::string& text, const std::string& path,
                                const FileAccess& files, const ImportSettings& settings) {
    return read_all(text, path, files, Main::memory, settings);
}

}  // namespace sunfleck::engine
