// Chooses the importer for a scene file: one so far.
#include "import/load.h"

#include "core/error.h"
#include "core/small_letters.h"
#include "import/pbrt/reader.h"

#include <filesystem>

namespace sunfleck {

SceneDescription load_scene(const std::string& path) {
    const std::string ending = small_letters(std::filesystem::path(path).extension().string());
    if (ending == ".gltf" || ending == ".glb")
        throw Error({path}, "is a glTF scene, and those of pbrt-v4 alone are read",
                    "convert it to pbrt-v4");
    std::error_code code;
    if (std::filesystem::is_directory(path, code))
        throw Error({path}, "is a folder", "name the scene file in it");
    return read_pbrt(path);
}

}  // namespace sunfleck
