// Chooses the importer for a scene file: one so far.
#include "import/load.h"

#include "core/small_letters.h"
#include "import/pbrt/reader.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {

SceneDescription load_scene(const std::string& path) {
    if (path == "-") return read_pbrt_input();
    const std::string ending = small_letters(std::filesystem::path(path).extension().string());
    if (ending == ".gltf" || ending == ".glb")
        throw Error({path}, "is a glTF scene, and those of pbrt-v4 alone are read",
                    "convert it to pbrt-v4");
    return read_pbrt(path);
}

}  // namespace sunfleck::engine
