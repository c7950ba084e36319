// Camera "perspective": field of view, screen, lens.
#include "import/pbrt/camera.h"

#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

void want(bool right, const Statement& camera, const std::string& fault, const std::string& mend) {
    if (!right) throw Error(camera.where, fault, mend);
}

[[noreturn]] void refuse(const Statement& camera) {
    if (camera.type == "realistic")
        throw Error(camera.where, "camera \"realistic\" is not simulated",
                    "use \"perspective\" with \"fov\", \"lensradius\" and \"focaldistance\"");
    static constexpr std::array<std::string_view, 3> kTypes = {"perspective", "orthographic",
                                                               "spherical"};
    throw Error(camera.where, "unknown camera " + in_quotes(camera.type),
                use_one_of(kTypes, camera.type));
}

std::optional<std::array<double, 4>> screen_of(const Statement& camera) {
    const auto window = camera.reals("screenwindow", 4);
    if (!window) return std::nullopt;
    const auto& w = *window;
    want(w[0] < w[1] && w[2] < w[3], camera, "an empty \"screenwindow\"",
         "give x0 x1 y0 y1 that rise");
    return std::array<double, 4>{w[0], w[1], w[2], w[3]};
}

double aspect_of(const Statement& camera, const Vec2i& size) {
    const double aspect = camera.real("frameaspectratio", double(size.x) / size.y);
    want(aspect > 0, camera, "\"frameaspectratio\" is not positive", "use width over height");
    return aspect;
}

void read_lens(const Statement& camera, ScreenCamera& result) {
    result.lens_radius = camera.real("lensradius", 0);
    result.focal_distance = camera.real("focaldistance", 1e6);
    want(result.lens_radius >= 0, camera, "\"lensradius\" is negative", "use 0 or more");
    want(result.focal_distance > 0, camera, "\"focaldistance\" is not positive",
         "use the distance of what is sharp");
}

PerspectiveCamera perspective(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    const double fov = camera.real("fov", 90);
    want(fov > 0 && fov < 180, camera, "\"fov\" is not in (0, 180)", "use 45, for example");
    PerspectiveCamera result =
        make_perspective(to_world, size, fov, aspect_of(camera, size), screen_of(camera));
    read_lens(camera, result);
    return result;
}

OrthographicCamera orthographic(const Statement& camera, const Matrix& to_world,
                                const Vec2i& size) {
    OrthographicCamera result;
    result.camera_to_world = to_world;
    result.resolution = size;
    set_screen(result, aspect_of(camera, size), screen_of(camera));
    read_lens(camera, result);
    return result;
}

SphericalCamera spherical(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    const std::string map = camera.text("mapping").value_or("equalarea");
    static constexpr std::array<std::string_view, 2> kMaps = {"equalarea", "equirectangular"};
    if (map != kMaps[0] && map != kMaps[1])
        throw Error(camera.where, "unknown mapping " + in_quotes(map), use_one_of(kMaps, map));
    return {to_world, size, map == kMaps[0] ? SphereMap::equal_area : SphereMap::equirectangular};
}

Camera camera_of(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    if (camera.type == "perspective") return perspective(camera, to_world, size);
    if (camera.type == "orthographic") return orthographic(camera, to_world, size);
    if (camera.type == "spherical") return spherical(camera, to_world, size);
    refuse(camera);
}

}  // namespace

void finish_camera(Reading& reading) {
    const Statement none{"Camera", "perspective", {reading.scene.path}, {}, nullptr};
    const Statement& camera = reading.options.camera ? *reading.options.camera : none;
    const Motion& motion = reading.options.camera_from_world;
    const Matrix to_world = reading.still({motion[0].inverse(), motion[1].inverse()}, camera.where);
    if (reading.options.camera) reading.log.count_word(camera.keyword, camera.type);
    reading.scene.camera = camera_of(camera, to_world, reading.scene.film.resolution);
    camera.ignore({"shutteropen", "shutterclose"});
    reading.log.warn_unused(camera);
}

}  // namespace sunfleck::engine
