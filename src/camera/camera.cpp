// Perspective camera: rays through a thin lens, and pbrt-v4's screen.
#include "camera/camera.h"

#include "math/warp.h"

#include <cmath>

namespace sunfleck {

namespace {

/// Matrix without its translation, applied to v.
Vec3d turn(const Matrix& matrix, const Vec3d& v) {
    Vec3d result;
    matrix.multDirMatrix(v, result);
    return result;
}

double volume_scale(const Matrix& matrix) {
    const Vec3d x = turn(matrix, {1, 0, 0});
    const Vec3d y = turn(matrix, {0, 1, 0});
    return std::abs(x.cross(y).dot(turn(matrix, {0, 0, 1})));
}

}  // namespace

CameraRay PerspectiveCamera::ray(const Vec2d& film, const Vec2d& lens) const {
    const Vec2d screen = screen_max - screen_min;
    const Vec2d pixel(screen.x / resolution.x, screen.y / resolution.y);
    const Vec3d through(screen_min.x + film.x * pixel.x, screen_max.y - film.y * pixel.y, 1);

    // A pixel's patch of the plane z = 1, as a solid angle in the world.
    const double length = turn(camera_to_world, through).length();
    const double solid_angle =
        pixel.x * pixel.y * volume_scale(camera_to_world) / (length * length * length);

    const Vec2d on_lens = lens_radius > 0 ? concentric_disc(lens) * lens_radius : Vec2d(0);
    const Vec3d origin(on_lens.x, on_lens.y, 0);
    // Towards the point of the focal plane that the ray through the lens's centre meets.
    const Vec3d local = lens_radius > 0 ? through * focal_distance - origin : through;
    const Vec3d direction = turn(camera_to_world, local);
    return {origin * camera_to_world, direction / direction.length(),
            static_cast<float>(std::sqrt(solid_angle))};
}

PerspectiveCamera make_perspective(const Matrix& camera_to_world, const Vec2i& resolution,
                                   double fov, double frame_aspect,
                                   const std::optional<std::array<double, 4>>& screen_window) {
    const double a = frame_aspect;
    std::array<double, 4> window = {-1, 1, -1 / a, 1 / a};
    if (a >= 1) window = {-a, a, -1, 1};
    if (screen_window) window = *screen_window;

    const SinCos half = sin_cos_turn(fov / 720);
    const double tangent = half.sin / half.cos;
    PerspectiveCamera camera;
    camera.camera_to_world = camera_to_world;
    camera.resolution = resolution;
    camera.screen_min = Vec2d(window[0], window[2]) * tangent;
    camera.screen_max = Vec2d(window[1], window[3]) * tangent;
    return camera;
}

}  // namespace sunfleck
