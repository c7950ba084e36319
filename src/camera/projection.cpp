// Projection of points, one function per camera type.
#include "camera/projection.h"

#include "camera/camera_frame.h"
#include "camera/screen.h"
#include "math/warp.h"

#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the film area in pixels per area of the plane z = 1 (or of the screen).
double pixels_by_area(const ScreenCamera& camera) {
    const Vec2d pixel = pixel_of(camera);
    return 1 / (pixel.x * pixel.y);
}

/// Maps a direction from the camera, in a frame with z up, to the unit square, with the area per
/// solid angle.
std::pair<Vec2d, double> on_square(SphereMap map, const Vec3d& z_up) {
    if (map == SphereMap::equal_area) return {sphere_to_square(z_up), 1 / (4 * kPiDouble)};
    const float flat = std::hypot(static_cast<float>(z_up.x), static_cast<float>(z_up.y));
    const double polar = std::atan2(flat, static_cast<float>(z_up.z));
    double azimuth = std::atan2(static_cast<float>(z_up.y), static_cast<float>(z_up.x));
    if (azimuth < 0) azimuth += 2 * kPiDouble;
    const double sine = std::max(static_cast<double>(flat), 1e-12);
    return {{azimuth / (2 * kPiDouble), polar / kPiDouble}, 1 / (2 * kPiDouble * kPiDouble * sine)};
}

}  // namespace

Projection::Projection(Camera camera) : camera_(std::move(camera)) {
    const Matrix& to_world = frame_of(camera_);
    world_to_camera_ = to_world.inverse();
    volume_ = volume_scale(to_world);
}

std::optional<Sight> Projection::sight_of(const Vec3d& point, const Vec2d& lens) const {
    const Vec3d p = point * world_to_camera_;
    if (const auto* c = std::get_if<PerspectiveCamera>(&camera_)) {
        if (!(p.z > 0)) return {};
        const Vec3d from = on_lens(*c, lens);
        // The point where the ray crosses z = 1 (with a lens: the focal plane, scaled to z = 1).
        const Vec3d along = (p - from) / p.z;
        const Vec2d screen = c->lens_radius > 0 ? Vec2d(from.x / c->focal_distance + along.x,
                                                        from.y / c->focal_distance + along.y)
                                                : Vec2d(along.x, along.y);
        const double length = turn(c->camera_to_world, along).length();
        const double solid_angle = volume_ / (length * length * length);  // of unit area there
        const double distance = length * p.z;
        return Sight{film_point(*c, screen), from * c->camera_to_world,
                     pixels_by_area(*c) / (solid_angle * distance * distance)};
    }
    if (const auto* c = std::get_if<OrthographicCamera>(&camera_)) {
        if (!(p.z > 0)) return {};
        const Vec3d offset = on_lens(*c, lens);
        const Vec3d along =
            c->lens_radius > 0 ? Vec3d(0, 0, 1) - offset / c->focal_distance : Vec3d(0, 0, 1);
        const Vec3d from = p - along * p.z;
        const Vec2d screen(from.x - offset.x, from.y - offset.y);
        const double area = volume_ / turn(c->camera_to_world, along).length();
        return Sight{film_point(*c, screen), from * c->camera_to_world, pixels_by_area(*c) / area};
    }
    const auto& c = std::get<SphericalCamera>(camera_);
    const double distance = (point - Vec3d(0) * c.camera_to_world).length();
    if (!(p.length() > 0)) return {};
    const Vec3d w = p.normalized();
    const auto [u, by_solid_angle] = on_square(c.map, {w.x, w.z, w.y});
    const Vec2d size(c.resolution);
    return Sight{u * size, Vec3d(0) * c.camera_to_world,
                 by_solid_angle * size.x * size.y / (distance * distance)};
}

}  // namespace sunfleck::engine
