// A camera of given direction is fitted to points, axis by axis, in closed form.
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

void FramedView::Edges::add(double beside, double towards) {
    above = std::max(above, towards + beside / slope);
    below = std::max(below, towards - beside / slope);
}

FramedView::FramedView(const Framing& framing, const Vec2i& resolution, const Vec3d& near)
    : framing_(framing),
      resolution_(resolution),
      near_(near),
      x_(framing.up.cross(framing.towards_camera).normalized()),
      z_(framing.towards_camera.normalized()) {
    y_ = z_.cross(x_);
    high_.slope = tangent_of_half(framing.yfov) * framing.fill;
    wide_.slope = high_.slope * resolution.x / resolution.y;
}

void FramedView::add(const Vec3d& point) {
    const Vec3d local = point - near_;
    wide_.add(local.dot(x_), local.dot(z_));
    high_.add(local.dot(y_), local.dot(z_));
}

void FramedView::add(const Bounds& box) {
    for (unsigned i = 0; i < 8; ++i)
        add(Vec3d((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                  (i & 4U) != 0 ? box.max.z : box.min.z));
}

PerspectiveCamera FramedView::camera(double least) const {
    const double distance = std::max({wide_.distance(), high_.distance(), least});
    const Vec3d place = near_ + x_ * wide_.shift() + y_ * high_.shift() + z_ * distance;
    return perspective_view(camera_frame(x_, y_, -z_, place), framing_.yfov, resolution_);
}

}  // namespace sunfleck::engine
