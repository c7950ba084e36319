// Camera "perspective": field of view, screen, lens.
#include "import/pbrt/camera.h"

#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck {
namespace {

void want(bool right, const Statement& camera, const std::string& fault, const std::string& mend) {
    if (!right) throw Error(camera.where, fault, mend);
}

void check_type(const Statement& camera) {
    if (camera.type == "perspective") return;
    static constexpr std::array<std::string_view, 3> kOthers = {"orthographic", "spherical",
                                                                "realistic"};
    const bool known = std::find(kOthers.begin(), kOthers.end(), camera.type) != kOthers.end();
    throw Error(camera.where,
                (known ? "unsupported camera " : "unknown camera ") + in_quotes(camera.type),
                "use \"perspective\"");
}

std::optional<std::array<double, 4>> screen_of(const Statement& camera) {
    const auto window = camera.reals("screenwindow", 4);
    if (!window) return std::nullopt;
    const auto& w = *window;
    want(w[0] < w[1] && w[2] < w[3], camera, "an empty \"screenwindow\"",
         "give x0 x1 y0 y1 that rise");
    return std::array<double, 4>{w[0], w[1], w[2], w[3]};
}

}  // namespace

void finish_camera(Reading& reading) {
    const Statement none{"Camera", "perspective", {reading.scene.path}, {}, nullptr};
    const Statement& camera = reading.options.camera ? *reading.options.camera : none;
    check_type(camera);
    const Motion& motion = reading.options.camera_from_world;
    if (motion[0] != motion[1])
        reading.warn(camera.where,
                     "motion is not simulated: things stand where they are at the "
                     "start");
    const Vec2i size = reading.scene.film.resolution;
    const double fov = camera.real("fov", 90);
    want(fov > 0 && fov < 180, camera, "\"fov\" is not in (0, 180)", "use 45, for example");
    const double aspect = camera.real("frameaspectratio", double(size.x) / size.y);
    want(aspect > 0, camera, "\"frameaspectratio\" is not positive", "use width over height");
    PerspectiveCamera& result = reading.scene.camera;
    result = make_perspective(motion[0].inverse(), size, fov, aspect, screen_of(camera));
    result.lens_radius = camera.real("lensradius", 0);
    result.focal_distance = camera.real("focaldistance", 1e6);
    want(result.lens_radius >= 0, camera, "\"lensradius\" is negative", "use 0 or more");
    want(result.focal_distance > 0, camera, "\"focaldistance\" is not positive",
         "use the distance of what is sharp");
    camera.ignore({"shutteropen", "shutterclose"});
    reading.warn_unused(camera);
}

}  // namespace sunfleck
