// Selects the importer for a scene file by its ending: glTF, a part, or else pbrt-v4.
#include "import/load.h"

#include "core/small_letters.h"
#include "import/asked_lights.h"
#include "import/gltf/reader.h"
#include "import/luminaires.h"
#include "import/medium_border.h"
#include "import/part/reader.h"
#include "import/pbrt/reader.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// The up axis of the world: as the user tells, or the usual one of the format.
UpAxis up_of(SceneFormat format, const std::string& path, const ImportSettings& settings) {
    if (format == SceneFormat::part) return up_of_part(path, settings);
    return settings.up.value_or(format == SceneFormat::gltf ? UpAxis::y : UpAxis::z);
}

void check_given(const SceneRequest& request, SceneFormat format) {
    for (const GivenFlag& flag : request.given)
        if (std::find(flag.formats.begin(), flag.formats.end(), format) == flag.formats.end())
            throw Error({flag.name}, "has no meaning for a scene file of this kind",
                        "leave it out");
}

SceneDescription read_as(SceneFormat format, const std::string& path, const SceneRequest& request) {
    if (path == "-") return read_pbrt_input(request.import);
    if (format == SceneFormat::gltf) return read_gltf(path, request.import);
    if (format == SceneFormat::part) return read_part(path, request.import);
    return read_pbrt(path, request.import);
}

}  // namespace

SceneFormat format_of(const std::string& path) {
    if (is_part(path)) return SceneFormat::part;
    const std::string ending = small_ending(path);
    if (ending == ".gltf" || ending == ".glb") return SceneFormat::gltf;
    return SceneFormat::pbrt;
}

Exposure usual_exposure(const std::string& path) {
    return {.is_automatic = format_of(path) != SceneFormat::pbrt};
}

SceneDescription load_scene(const std::string& path, const SceneRequest& request) {
    if (path.empty())
        throw Error({"scene"}, "the name of the scene's file is empty", "give the name of a file");
    const SceneFormat format = format_of(path);
    check_given(request, format);
    SceneDescription scene = read_as(format, path, request);
    const UpAxis up = up_of(format, path, request.import);
    set_luminaires(scene, request.luminaires, up);
    add_asked_lights(scene, request, format, up);
    if (request.fog)
        fill_with_fog(scene, *request.fog);
    else
        end_outer_medium(scene);
    return scene;
}

}  // namespace sunfleck::engine
