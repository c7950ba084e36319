// Chooses the importer for a scene file: one so far.
#include "import/load.h"

#include "core/error.h"
#include "import/pbrt/reader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace sunfleck {
namespace {

/// In small letters, with its point.
std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

}  // namespace

SceneDescription load_scene(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending == ".gltf" || ending == ".glb")
        throw Error({path}, "is a glTF scene, and those of pbrt-v4 alone are read",
                    "convert it to pbrt-v4");
    std::error_code code;
    if (std::filesystem::is_directory(path, code))
        throw Error({path}, "is a folder", "name the scene file in it");
    return read_pbrt(path);
}

}  // namespace sunfleck
