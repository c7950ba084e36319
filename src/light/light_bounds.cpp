// Bounds of each kind of light, and of several; the importance of a cluster.
#include "light/light_bounds.h"

#include "light/affine_area.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr double kAllWays = -1;
/// Outside the cone of a light there is no light; a margin covers rounding.
constexpr double kNoReach = 1 - 1e-6;

double sine(double cosine) {
    return std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

/// Returns the cosine of angle a minus angle b, or one if b is greater; both in [0, pi].
double cos_less(double cos_a, double cos_b, double sin_b) {
    if (cos_a >= cos_b) return 1;
    if (sin_b == 0) return cos_a * cos_b;
    return cos_a * cos_b + sine(cos_a) * sin_b;
}

LightBounds around(const Vec3d& position, double cos_spread, double intensity) {
    LightBounds bounds;
    bounds.box.extend(position);
    bounds.cos_spread = cos_spread;
    bounds.cos_reach = kNoReach;
    bounds.intensity = intensity;
    return bounds;
}

/// Sets box and cone of emitting surfaces.
void bound_surface(const EmittingTriangle& t, LightBounds& bounds) {
    for (const Vec3d& p : {t.p0, t.p0 + t.edge1, t.p0 + t.edge2}) bounds.box.extend(p);
    bounds.axis = t.normal;
}

/// The area vector is bilinear and hence between those of the corners. (Given normals may flip it
/// from point to point.)
void bound_surface(const EmittingPatch& patch, LightBounds& bounds) {
    bounds.box = patch.surface.bounds();
    Vec3d sum(0);
    std::array<Vec3d, 4> normals = patch.surface.area_vectors_at_corners();
    bool given = false;
    for (std::size_t i = 0; i < 4; ++i) {
        normals.at(i) = (patch.flip ? -normals.at(i) : normals.at(i)).normalized();
        sum += normals.at(i);
        given = given || patch.normals.at(i) != Vec3d(0);
    }
    bounds.axis = sum.normalized();
    for (const Vec3d& n : normals)
        bounds.cos_spread = std::min(bounds.cos_spread, n.dot(bounds.axis));
    if (given || !(bounds.cos_spread > 0)) bounds.cos_spread = kAllWays;
}

void bound_surface(const EmittingQuadric<Disk>& disk, LightBounds& bounds) {
    const Affine map(disk.to_world);
    bounds.box = disk.shape.bounds(map);
    bounds.axis = area_vector(map, Vec3d(0, 0, disk.flip ? -1 : 1)).normalized();
}

template <class Quadric>
void bound_surface(const EmittingQuadric<Quadric>& quadric, LightBounds& bounds) {
    bounds.box = quadric.shape.bounds(Affine(quadric.to_world));
    bounds.cos_spread = kAllWays;
}

LightBounds bounds_of_light(const AreaLight& light, double weight) {
    LightBounds bounds;
    bounds.two_sided = light.two_sided;
    std::visit([&](const auto& s) { bound_surface(s, bounds); }, light.surface);
    // Flat surfaces emit their flux over pi along the normal, round ones a quarter of that.
    const bool round = bounds.cos_spread == kAllWays;
    bounds.intensity = weight / (kPiDouble * (round ? 4 : 1) * (light.two_sided ? 2 : 1));
    return bounds;
}

LightBounds bounds_of_light(const SpotLight& light, double weight) {
    LightBounds bounds = around(light.position, light.cos_total, weight / light.power({}));
    bounds.axis = light.axis;
    return bounds;
}

LightBounds bounds_of_light(const ProjectionLight& light, double weight) {
    const double corner2 = 1 + light.half.length2();
    LightBounds bounds =
        around(light.position, 1 / std::sqrt(corner2), weight / (4 * light.half.x * light.half.y));
    bounds.axis = light.to_world.z;
    return bounds;
}

LightBounds bounds_of_light(const PointLight& light, double weight) {
    return around(light.position, kAllWays, weight / (4 * kPiDouble));
}
LightBounds bounds_of_light(const GoniometricLight& light, double weight) {
    return around(light.position, kAllWays, weight / (4 * kPiDouble));
}

/// Nothing is chosen to be seen from a point that is not seen from any.
std::optional<LightBounds> bounds_of_light(const MediumLight&, double) {
    return {};
}
std::optional<LightBounds> bounds_of_light(const DistantLight&, double) {
    return {};
}
std::optional<LightBounds> bounds_of_light(const SunLight&, double) {
    return {};
}
std::optional<LightBounds> bounds_of_light(const InfiniteLight&, double) {
    return {};
}
std::optional<LightBounds> bounds_of_light(const ImageInfiniteLight&, double) {
    return {};
}
std::optional<LightBounds> bounds_of_light(const PortalLight&, double) {
    return {};
}

/// Returns the cosine of the largest angle between `axis` and the normals of the bounds.
double cos_beside(const LightBounds& bounds, const Vec3d& axis) {
    const double cosine = axis.dot(bounds.axis);
    if (cosine + bounds.cos_spread <= 0) return kAllWays;
    return cosine * bounds.cos_spread - sine(cosine) * sine(bounds.cos_spread);
}

}  // namespace

std::optional<LightBounds> bounds_of(const Light& light, double weight) {
    const auto of = [&](const auto& l) -> std::optional<LightBounds> {
        return bounds_of_light(l, weight);
    };
    return std::visit(of, light);
}

LightBounds merged(std::span<const LightBounds> parts) {
    LightBounds all;
    all.cos_reach = 1;
    Vec3d sum(0);
    for (const LightBounds& part : parts) {
        all.box.extend(part.box);
        all.two_sided = all.two_sided || part.two_sided;
        all.cos_reach = std::min(all.cos_reach, part.cos_reach);
        all.intensity += part.intensity;
        const bool turned = part.two_sided && sum.dot(part.axis) < 0;
        sum += part.axis * (turned ? -part.intensity : part.intensity);
    }
    const double length = sum.length();
    if (length > 0) all.axis = sum / length;
    for (LightBounds part : parts) {
        if (part.two_sided && part.axis.dot(all.axis) < 0) part.axis = -part.axis;
        all.cos_spread = std::min(all.cos_spread, cos_beside(part, all.axis));
    }
    return all;
}

/// Conty Estevez and Kulla, section 4.3, in float because of its arc cosines.
double measure_of(const LightBounds& bounds) {
    const Vec3d size = bounds.box.max - bounds.box.min;
    const double area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
    const float spread = std::acos(static_cast<float>(std::clamp(bounds.cos_spread, -1.0, 1.0)));
    const float reach = std::acos(static_cast<float>(std::clamp(bounds.cos_reach, -1.0, 1.0)));
    const float widest = std::min(spread + reach, kPi);
    const float solid_angle =
        2 * kPi * (1 - std::cos(spread)) + kPi / 2 *
                                               (2 * (widest - spread) * std::sin(spread) -
                                                std::cos(spread - 2 * widest) + std::cos(spread));
    return area * static_cast<double>(solid_angle) * bounds.intensity;
}

LightCluster::LightCluster(const LightBounds& bounds)
    : center_(bounds.box.center()),
      radius2_((bounds.box.max - bounds.box.min).length2() / 4),
      axis_(bounds.axis),
      cos_spread_(bounds.cos_spread),
      sin_spread_(sine(bounds.cos_spread)),
      cos_reach_(bounds.cos_reach),
      intensity_(bounds.intensity),
      two_sided_(bounds.two_sided) {}

double LightCluster::importance(const Receiver& at) const {
    const Vec3d way = center_ - Vec3d(at.position);
    const double distance2 = way.length2();
    // Within the sphere, light may come from all directions.
    if (!(distance2 > radius2_ * (1 + 1e-9)))
        return radius2_ > 0 ? intensity_ / radius2_ : intensity_ * 1e30;
    const Vec3d towards = way / std::sqrt(distance2);
    const double sin2_width = radius2_ / distance2;
    const double cos_width = std::sqrt(1 - sin2_width);
    const double sin_width = std::sqrt(sin2_width);
    double facing = -axis_.dot(towards);
    if (two_sided_) facing = std::abs(facing);
    const double aside = cos_less(facing, cos_spread_, sin_spread_);
    const double emitted = cos_less(aside, cos_width, sin_width);
    if (emitted < cos_reach_ - 1e-9 || !(emitted > 0)) return 0;
    double result = intensity_ * emitted / distance2;
    if (at.normal != Vec3(0)) {
        const double incoming = towards.dot(Vec3d(at.normal));
        const double arrives = cos_less(incoming, cos_width, sin_width);
        result *= std::max(arrives, 0.0);
    }
    return result;
}

}  // namespace sunfleck::engine
