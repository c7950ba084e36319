// Chooses the importer for a scene file: one so far.
#include "import/load.h"

#include "import/pbrt/reader.h"

namespace sunfleck {

SceneDescription load_scene(const std::string& path) {
    return read_pbrt(path);
}

}  // namespace sunfleck
