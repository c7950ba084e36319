// Visible points of a camera path, and the width of a pixel along it.
#include "camera_paths/camera_path.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns the lower bound of the gather radius: some spacings of the float positions.
float smallest_radius(const Vec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), 1e-30F}) * 0x1p-20F;
}

}  // namespace

void CameraPath::gather(const Hit& hit, const Bsdf& bsdf, std::uint8_t kinds) {
    VisiblePoint point = new_point();
    const bool behind = hit.normal.dot(direction_) > 0;
    point.disc.position = hit.position;
    point.disc.radius = radius_at(hit.position);
    point.disc.normal = behind ? -hit.normal : hit.normal;
    point.disc.kinds = kinds;
    point.disc.both_sides = gathers(bsdf, 1, -1);
    point.shading_normal = hit.shading_normal;
    point.tangent = hit.tangent;
    if (const auto* lambert = std::get_if<Lambert>(&bsdf)) {
        point.throughput *= lambert->albedo / kPi;
        point.bsdf = kLambertian;
    } else {
        point.bsdf = pass_.scene.keep(hit, bsdf);
    }
    points_.push_back(point);
}

/// Returns a visible point at the end of the path, without its place.
VisiblePoint CameraPath::new_point() const {
    VisiblePoint point;
    point.disc.bounces = bounces_;
    // Behind a rough surface the camera path causes the noise, and the disc is wider already.
    if (rough_ == 0) point.disc.indirect_radius_scale = pass_.indirect_radius_scale;
    point.wo = -direction_;
    point.throughput = throughput_ * weight_;
    point.pixel = pixel_;
    point.hero = static_cast<std::uint8_t>(hero_.chosen);
    point.single_wavelength = hero_.single;
    point.after_rough = rough_ > 0;
    return point;
}

/// Footprint = pixel angle times path length; a refraction scales the angle by the ratio of
/// indices. Curvature and grazing angles are ignored, because the radius shrinks anyway.
void CameraPath::grow_footprint(float distance) {
    footprint_ += footprint_angle_ * distance;
    spread_ += spread_angle_ * distance;
    length_ += distance;
}

float CameraPath::radius_at(const Vec3& position) const {
    const CameraPathSettings& settings = pass_.settings;
    const auto factor = static_cast<float>(pass_.radius_factor);
    const float floor = smallest_radius(position);
    if (settings.radius) return std::max(floor, static_cast<float>(*settings.radius) * factor);
    // A footprint that varies between passes would give 1 / (pi r^2) a heavy tail.
    const float width =
        std::clamp(footprint_, 0.25F * first_footprint_, 4 * first_footprint_) + spread_;
    return std::max(floor, pass_.first_radius * width * factor);
}

}  // namespace sunfleck::engine
