// Daylight and environment pictures, by the request.
#include "import/asked_lights.h"

#include "light/lumens.h"
#include "sky/compass.h"

#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

bool emits(const ShapeDescription& shape) {
    return shape.emission.has_value();
}

bool has_light(const SceneDescription& scene) {
    return !scene.lights.empty() || std::any_of(scene.shapes.begin(), scene.shapes.end(), emits);
}

bool is_given(const SceneRequest& request, const std::string& flag) {
    return std::any_of(request.given.begin(), request.given.end(),
                       [&](const GivenFlag& given) { return given.name == flag; });
}

/// @throws Error  if one of the flags is given, which then has no meaning.
void refuse_given(const SceneRequest& request, std::initializer_list<const char*> flags,
                  const std::string& why, const std::string& mend) {
    for (const char* flag : flags)
        if (is_given(request, flag)) throw Error({flag}, why, mend);
}

}  // namespace

void add_asked_lights(SceneDescription& scene, const SceneRequest& request, SceneFormat format,
                      UpAxis up) {
    const Affine axes = compass(up, request.north);
    const bool needs_light =
        format != SceneFormat::pbrt && !request.environment && !has_light(scene);
    const bool has_daylight = request.has_daylight || needs_light;
    if (needs_light && !request.has_daylight) {
        const SunPosition& sun = request.daylight.sun;
        scene.warnings.add({scene.path}, fmt::format("there is no light: sky and sun are used "
                                                     "(--sun {:g},{:g})",
                                                     sun.azimuth, sun.elevation));
    }
    if (!has_daylight)
        refuse_given(request, {"--turbidity", "--ground-albedo"}, "has a meaning for a sky alone",
                     "add --sun, or leave it out");
    if (!has_daylight && !request.environment)
        refuse_given(request, {"--north"}, "has a meaning for a sky or an environment alone",
                     "add --sun or --environment, or leave it out");
    // A pixel of one is 1 W/(m^2 sr) of white in pbrt's scenes, and 1 cd/m^2 in others.
    const double unit = format == SceneFormat::pbrt ? 1 : 1 / kLumensPerWatt;
    if (has_daylight)
        add_daylight(scene, request.daylight, axes, {request.has_daylight ? "--sun" : scene.path});
    if (request.environment) {
        if (request.environment->file.empty())
            throw Error({"--environment-scale"}, "has no meaning without a picture",
                        "add --environment");
        EnvironmentPicture picture = *request.environment;
        picture.scale *= unit;
        add_environment(scene, picture, axes);
    }
}

}  // namespace sunfleck::engine
