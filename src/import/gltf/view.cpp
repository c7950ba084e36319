// Cameras look along -z of their node, with y up.
#include "import/gltf/view.h"

#include "import/gltf/camera_choice.h"
#include "math/trigonometry.h"
#include "scene/framing.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kLeastPixels = 16;

/// Returns 1280 x 720, or the longest side at another aspect.
Vec2i resolution_of(double aspect) {
    const double usual = 1280.0 / 720;
    const auto pixels = [](double x) {
        return std::max(kLeastPixels, static_cast<int>(std::lround(x)));
    };
    if (aspect >= usual) return {kUsualResolution.x, pixels(kUsualResolution.x / aspect)};
    return {pixels(kUsualResolution.y * aspect), kUsualResolution.y};
}

/// Scales of nodes neither stretch nor mirror the picture.
Matrix frame_of_node(const GltfNode& node) {
    const Matrix& m = node.to_world;
    const auto row = [&](int i) { return Vec3d(m[i][0], m[i][1], m[i][2]); };
    const Vec3d ahead = -row(2);
    const Vec3d right = ahead.cross(row(1));
    if (!(right.length() > 0))
        node.place.refuse("is scaled to nothing: its camera has no direction",
                          "choose another (--camera), or another time (--frame-time)");
    return camera_frame(right, right.cross(ahead), ahead, row(3));
}

Camera camera_of(const JsonPlace& camera, const GltfNode& node, FilmDescription& film) {
    constexpr double kLarge = 1e9;
    const Matrix frame = frame_of_node(node);
    const JsonPlace type = camera.at("type");
    if (type.text() == "perspective") {
        const JsonPlace view = camera.at("perspective");
        film.resolution = resolution_of(view.number("aspectRatio", 16.0 / 9, 1e-3, 1e3));
        return perspective_view(frame, view.number("yfov", 0.8, 1e-6, kPiDouble * 0.999),
                                film.resolution);
    }
    if (type.text() != "orthographic")
        type.refuse("is no type of camera", "write perspective or orthographic");
    const JsonPlace view = camera.at("orthographic");
    const double x = view.number("xmag", 1, 1 / kLarge, kLarge);
    const double y = view.number("ymag", 1, 1 / kLarge, kLarge);
    film.resolution = resolution_of(x / y);
    OrthographicCamera made;
    made.camera_to_world = frame;
    made.resolution = film.resolution;
    made.screen_min = {-x, -y};
    made.screen_max = {x, y};
    return made;
}

/// Returns a camera that sees the bounds from the front, to the right and above.
Camera framing(const Bounds& bounds, FilmDescription& film) {
    constexpr double kFov = 40 * kPiDouble / 180;
    const double sine = sin_cos_2pi(kFov / (4 * kPiDouble)).sin;
    film.resolution = kUsualResolution;
    if (bounds.is_empty()) return PerspectiveCamera();
    const Vec3d centre = bounds.center();
    const double radius = std::max(bounds.radius(), 1e-6);
    const Vec3d towards = Vec3d(0.45, 0.35, 1).normalized();
    const Vec3d right = Vec3d(0, 1, 0).cross(towards);
    return perspective_view(
        camera_frame(right, towards.cross(right), -towards, centre + towards * (radius / sine)),
        kFov, film.resolution);
}

}  // namespace

void set_view(const GltfDocument& document, const GltfNodes& nodes, const std::string& chosen,
              SceneDescription& scene) {
    if (const auto node = chosen_camera(document, nodes, chosen)) {
        scene.camera =
            camera_of(document.element("cameras", node->place.at("camera")), *node, scene.film);
        return;
    }
    scene.warnings.add({scene.path}, "there is no camera: one that sees the whole scene is used");
    scene.camera = framing(bounds_of_scene(scene), scene.film);
}

}  // namespace sunfleck::engine
