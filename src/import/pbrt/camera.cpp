// Cameras: field of view, screen, lens, mapping.
#include "import/pbrt/camera.h"

#include "import/pbrt/reading.h"
#include "import/pbrt/transforms.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {
namespace {

void want(bool right, const Statement& camera, const std::string& fault, const std::string& mend) {
    if (!right) throw Error(camera.where, fault, mend);
}

std::optional<std::array<double, 4>> screen_of(const Statement& camera) {
    const auto window = camera.reals("screenwindow", 4);
    if (!window) return std::nullopt;
    const auto& w = *window;
    want(w[0] < w[1] && w[2] < w[3], camera, "an empty \"screenwindow\"",
         "give x0 x1 y0 y1 with x0 < x1 and y0 < y1");
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
         "use the distance of the plane in focus");
}

Camera perspective(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    const double fov = camera.real("fov", 90);
    want(fov > 0 && fov < 180, camera, "\"fov\" is not in (0, 180)", "use 45, for example");
    PerspectiveCamera result =
        make_perspective(to_world, size, fov, aspect_of(camera, size), screen_of(camera));
    read_lens(camera, result);
    return result;
}

Camera orthographic(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    OrthographicCamera result;
    result.camera_to_world = to_world;
    result.resolution = size;
    set_screen(result, aspect_of(camera, size), screen_of(camera));
    read_lens(camera, result);
    return result;
}

Camera spherical(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    const std::string map = camera.text("mapping").value_or("equalarea");
    static constexpr std::array<std::string_view, 2> kMaps = {"equalarea", "equirectangular"};
    if (map != kMaps[0] && map != kMaps[1])
        throw Error(camera.where, "unknown mapping " + in_quotes(map), use_one_of(kMaps, map));
    return SphericalCamera{to_world, size,
                           map == kMaps[0] ? SphereMap::equal_area : SphereMap::equirectangular};
}

[[noreturn]] Camera realistic(const Statement& camera, const Matrix&, const Vec2i&) {
    throw Error(camera.where, "camera \"realistic\" is not simulated",
                "use \"perspective\" with \"fov\", \"lensradius\" and \"focaldistance\"");
}

struct CameraRow {
    std::string_view word;
    Camera (*maker)(const Statement&, const Matrix& to_world, const Vec2i& size);
    Treatment treatment;
    std::string_view read_as;  // as in WordRow
};

constexpr auto kCameras = std::to_array<CameraRow>({
    {"perspective", perspective, kExact,
     "`fov` (of the shorter axis, 90), `frameaspectratio`, `screenwindow`, `lensradius`, "
     "`focaldistance`, `shutteropen`, `shutterclose`"},
    {"orthographic", orthographic, kExact,
     "the same but for `fov`. With a lens each film point is seen through a lens around itself "
     "(pbrt-v4 puts every lens at the camera's origin)"},
    {"spherical", spherical, kExact,
     "`mapping` `\"equalarea\"` (the default) or `\"equirectangular\"`; the camera's y axis is up"},
    {"realistic", realistic, kRefused, "lens files are not read; the message names what to use"},
});

}  // namespace

Camera camera_of(const Statement& camera, const Matrix& to_world, const Vec2i& size) {
    const auto* const row = std::find_if(kCameras.begin(), kCameras.end(),
                                         [&](const CameraRow& r) { return r.word == camera.type; });
    if (row != kCameras.end()) {
        want(is_finite_float(to_world), camera, "the camera is beyond the range of floats",
             "keep the entries of its matrix below 3.4e38");
        return row->maker(camera, to_world, size);
    }
    std::vector<std::string_view> simulated;
    for (const CameraRow& known : kCameras)
        if (known.treatment != kRefused) simulated.push_back(known.word);
    throw Error(camera.where, "unknown camera " + in_quotes(camera.type),
                use_one_of(simulated, camera.type));
}

std::span<const WordRow> camera_words() {
    static constexpr auto kWords = word_rows("Camera", kCameras);
    return kWords;
}

void finish_camera(Reading& reading) {
    const Statement none{"Camera", "perspective", {reading.scene.path}, {}, nullptr};
    const Statement& camera = reading.options.camera ? *reading.options.camera : none;
    const Motion& motion = reading.options.camera_from_world;
    const Matrix to_world = reading.still({motion[0].inverse(), motion[1].inverse()}, camera.where);
    if (reading.options.camera) reading.log.count_word(camera.keyword, camera.type);
    reading.scene.camera = camera_of(camera, to_world, reading.scene.film.resolution);
    reading.scene.media.at_camera =
        reading.media.number_of(reading.options.camera_medium, camera.where);
    camera.ignore({"shutteropen", "shutterclose"});
    reading.log.warn_unused(camera);
}

}  // namespace sunfleck::engine
