// Selects the importer for a scene file by its ending: glTF, or else pbrt-v4.
#include "import/load.h"

#include "core/small_letters.h"
#include "import/gltf/reader.h"
#include "import/pbrt/reader.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {

SceneDescription load_scene(const std::string& path, const ImportSettings& settings) {
    if (path.empty())
        throw Error({"scene"}, "the name of the scene's file is empty", "give the name of a file");
    if (path == "-") return read_pbrt_input();
    const std::string ending = small_letters(std::filesystem::path(path).extension().string());
    if (ending == ".gltf" || ending == ".glb") return read_gltf(path, settings);
    return read_pbrt(path);
}

}  // namespace sunfleck::engine
