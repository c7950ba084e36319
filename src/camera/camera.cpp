// Rays through a thin lens, and pbrt-v4's screen; spheres of directions.
#include "camera/camera.h"

#include "camera/screen.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

CameraRay PerspectiveCamera::ray(const Vec2d& film, const Vec2d& lens) const {
    const Vec2d pixel = pixel_of(*this);
    const Vec2d point = on_screen(*this, film);
    const Vec3d through(point.x, point.y, 1);

    // A pixel's patch of the plane z = 1, as a solid angle in the world.
    const double length = turn(camera_to_world, through).length();
    const double solid_angle =
        pixel.x * pixel.y * volume_scale(camera_to_world) / (length * length * length);

    const Vec3d origin = on_lens(*this, lens);
    // Towards the point of the focal plane that the ray through the lens's centre meets.
    const Vec3d local = lens_radius > 0 ? through * focal_distance - origin : through;
    const Vec3d direction = turn(camera_to_world, local);
    return {origin * camera_to_world, direction / direction.length(),
            static_cast<float>(std::sqrt(solid_angle)), 0};
}

CameraRay OrthographicCamera::ray(const Vec2d& film, const Vec2d& lens) const {
    const Vec2d pixel = pixel_of(*this);
    const Vec2d point = on_screen(*this, film);
    const Vec3d offset = on_lens(*this, lens);
    const Vec3d origin = Vec3d(point.x, point.y, 0) + offset;
    const Vec3d local = lens_radius > 0 ? Vec3d(0, 0, focal_distance) - offset : Vec3d(0, 0, 1);
    const Vec3d direction = turn(camera_to_world, local);
    // A pixel's patch of the screen, as it is seen along z.
    const double area = pixel.x * pixel.y * volume_scale(camera_to_world) /
                        turn(camera_to_world, {0, 0, 1}).length();
    return {origin * camera_to_world, direction / direction.length(), 0,
            static_cast<float>(std::sqrt(area))};
}

CameraRay SphericalCamera::ray(const Vec2d& film, const Vec2d&) const {
    const Vec2d u(film.x / resolution.x, film.y / resolution.y);
    double solid_angle = 4 * kPiDouble / (double(resolution.x) * resolution.y);
    Vec3d z_up;
    if (map == SphereMap::equal_area) {
        // Filters reach beyond the square, where it goes on as it was folded.
        Vec2d inside = u;
        if (inside.x < 0 || inside.x > 1) inside = {inside.x < 0 ? -u.x : 2 - u.x, 1 - u.y};
        if (inside.y < 0 || inside.y > 1)
            inside = {1 - inside.x, inside.y < 0 ? -inside.y : 2 - inside.y};
        z_up = uniform_sphere(inside);
    } else {
        const SinCos polar = sin_cos_2pi(u.y / 2);
        const SinCos azimuth = sin_cos_2pi(u.x);
        z_up = {polar.sin * azimuth.cos, polar.sin * azimuth.sin, polar.cos};
        // 2 pi by pi, times sin(theta); a pixel at a pole is wide enough to hold some of it.
        const double sine = std::max(std::abs(polar.sin), 0.25 / resolution.y);
        solid_angle *= kPiDouble / 2 * sine;
    }
    const Vec3d direction = turn(camera_to_world, {z_up.x, z_up.z, z_up.y});
    return {Vec3d(0) * camera_to_world, direction / direction.length(),
            static_cast<float>(std::sqrt(solid_angle)), 0};
}

void set_screen(ScreenCamera& camera, double frame_aspect,
                const std::optional<std::array<double, 4>>& window) {
    const double a = frame_aspect;
    std::array<double, 4> span = {-1, 1, -1 / a, 1 / a};
    if (a >= 1) span = {-a, a, -1, 1};
    if (window) span = *window;
    camera.screen_min = {span[0], span[2]};
    camera.screen_max = {span[1], span[3]};
}

PerspectiveCamera make_perspective(const Matrix& camera_to_world, const Vec2i& resolution,
                                   double fov, double frame_aspect,
                                   const std::optional<std::array<double, 4>>& screen_window) {
    PerspectiveCamera camera;
    camera.camera_to_world = camera_to_world;
    camera.resolution = resolution;
    set_screen(camera, frame_aspect, screen_window);
    const SinCos half = sin_cos_2pi(fov / 720);
    camera.screen_min *= half.sin / half.cos;
    camera.screen_max *= half.sin / half.cos;
    return camera;
}

void set_resolution(Camera& camera, const Vec2i& resolution) {
    const auto keep_shorter_axis = [&](ScreenCamera& screen) {
        const Vec2i before = screen.resolution;
        if (std::int64_t{resolution.x} * before.y == std::int64_t{resolution.y} * before.x) return;
        const Vec2d center = (screen.screen_min + screen.screen_max) * 0.5;
        const Vec2d size = screen.screen_max - screen.screen_min;
        const double half = std::min(size.x, size.y) * 0.5;
        const double aspect = static_cast<double>(resolution.x) / resolution.y;
        const Vec2d extent(aspect >= 1 ? half * aspect : half, aspect >= 1 ? half : half / aspect);
        screen.screen_min = center - extent;
        screen.screen_max = center + extent;
    };
    if (auto* perspective = std::get_if<PerspectiveCamera>(&camera))
        keep_shorter_axis(*perspective);
    if (auto* parallel = std::get_if<OrthographicCamera>(&camera)) keep_shorter_axis(*parallel);
    std::visit([&](auto& c) { c.resolution = resolution; }, camera);
}

}  // namespace sunfleck::engine
