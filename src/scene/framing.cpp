// A camera of given direction is fitted to the corners of a box, axis by axis, in closed form.
#include "scene/framing.h"

#include "geometry/measure.h"
#include "math/trigonometry.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns the tangent of half an angle. @param angle  in radians.
double tangent_of_half(double angle) {
    const SinCos half = sin_cos_2pi(angle / (4 * kPiDouble));
    return half.sin / half.cos;
}

/// The closest place from which all points lie between two lines of slope +-t: how far before the
/// origin, and how far beside it.
struct Fit {
    double distance = 0;
    double shift = 0;
};

/// @param beside, towards  coordinates of the points across the view and along it.
template <std::size_t N>
Fit fit(const std::array<double, N>& beside, const std::array<double, N>& towards, double t) {
    double above = -1e300;
    double below = -1e300;
    for (std::size_t i = 0; i < N; ++i) {
        above = std::max(above, towards.at(i) + beside.at(i) / t);
        below = std::max(below, towards.at(i) - beside.at(i) / t);
    }
    return {(above + below) / 2, (above - below) * t / 2};
}

}  // namespace

Matrix camera_frame(const Vec3d& right, const Vec3d& up, const Vec3d& ahead, const Vec3d& place) {
    Matrix m;
    const Vec3d x = right.normalized();
    const Vec3d y = up.normalized();
    const Vec3d z = ahead.normalized();
    for (int c = 0; c < 3; ++c) {
        m[0][c] = x[c];
        m[1][c] = y[c];
        m[2][c] = z[c];
        m[3][c] = place[c];
    }
    return m;
}

PerspectiveCamera perspective_view(const Matrix& to_world, double yfov, const Vec2i& resolution) {
    const double up = tangent_of_half(yfov);
    const double right = up * resolution.x / resolution.y;
    PerspectiveCamera camera;
    camera.camera_to_world = to_world;
    camera.resolution = resolution;
    camera.screen_min = {-right, -up};
    camera.screen_max = {right, up};
    return camera;
}

Bounds bounds_of_scene(const SceneDescription& scene) {
    Bounds all;
    for (const ShapeDescription& shape : scene.shapes) all.extend(bounds_of(shape.placed));
    for (const InstanceDescription& instance : scene.instances)
        for (const ShapeDescription& shape : scene.objects[instance.object])
            all.extend(image_of(bounds_of(shape.placed), Affine(instance.to_world)));
    return all;
}

PerspectiveCamera camera_that_sees(const Bounds& box, const Framing& framing,
                                   const Vec2i& resolution) {
    constexpr double kLeastSize = 1e-6;  // of a box that is a point
    const Vec3d z = framing.towards_camera.normalized();
    const Vec3d x = framing.up.cross(z).normalized();
    const Vec3d y = z.cross(x);
    const Vec3d centre = box.center();
    const double least = std::max(box.radius(), kLeastSize);
    const Vec3d half = (box.max - box.min) * 0.5;
    std::array<double, 8> across{};
    std::array<double, 8> height{};
    std::array<double, 8> towards{};
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3d corner(i % 2 == 0 ? half.x : -half.x, i / 2 % 2 == 0 ? half.y : -half.y,
                           i < 4 ? half.z : -half.z);
        across.at(i) = corner.dot(x);
        height.at(i) = corner.dot(y);
        towards.at(i) = corner.dot(z);
    }
    const double t = tangent_of_half(framing.yfov) * framing.fill;
    const Fit wide = fit(across, towards, t * resolution.x / resolution.y);
    const Fit high = fit(height, towards, t);
    const double distance = std::max({wide.distance, high.distance, least});
    const Vec3d place = centre + x * wide.shift + y * high.shift + z * distance;
    return perspective_view(camera_frame(x, y, -z, place), framing.yfov, resolution);
}

}  // namespace sunfleck::engine
