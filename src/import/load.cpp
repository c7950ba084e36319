// Selects the importer for a scene file; pbrt-v4 is the only format so far.
#include "import/load.h"

#include "core/small_letters.h"
#include "import/pbrt/reader.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {

SceneDescription load_scene(const std::string& path) {
    if (path.empty())
        throw Error({"scene"}, "the name of the scene's file is empty", "give the name of a file");
    if (path == "-") return read_pbrt_input();
    const std::string ending = small_letters(std::filesystem::path(path).extension().string());
    if (ending == ".gltf" || ending == ".glb")
        throw Error({path}, "is a glTF scene; only pbrt-v4 scenes can be read",
                    "convert it to pbrt-v4");
    return read_pbrt(path);
}

}  // namespace sunfleck::engine
