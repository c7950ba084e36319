// Goniometric light: texels of equal solid angle. Projection light: texels of equal area on a
// plane.
#include "light/image_point_lights.h"

#include "light/towards_point.h"
#include "math/warp.h"

namespace sunfleck::engine {
namespace {

/// Returns the direction in the light's frame. @param to_world  a rotation.
Vec3d to_local(const Affine& to_world, const Vec3d& w) {
    return {to_world.x.dot(w), to_world.y.dot(w), to_world.z.dot(w)};
}

/// Returns the third power of the cosine between the axis and a point of the plane z = 1: solid
/// angle per area there.
double cosine3(double x, double y) {
    const double distance2 = 1 + x * x + y * y;
    return 1 / (distance2 * std::sqrt(distance2));
}

std::optional<DirectSample> sample_at(const TowardsPoint& way, const TexelLight& light) {
    if (!(light.luminance > 0)) return {};
    return DirectSample{Vec3(way.direction), static_cast<float>(way.distance),
                        static_cast<float>(light.luminance / way.distance2), std::nullopt,
                        light.rgb};
}

}  // namespace

Emission GoniometricLight::sample_emission(const EmissionDimensions& u,
                                           const SceneSphere& sphere) const {
    const auto drawn = image->draw({u[2], u[3]});
    return {position,       to_world.vector(uniform_sphere(drawn.place)), power(sphere), Vec3(0), 0,
            drawn.light.rgb};
}

EmissionDimensions GoniometricLight::emission_dimensions(const LightRay& ray,
                                                         const SceneSphere&) const {
    const Vec2d way = image->numbers(sphere_to_square(to_local(to_world, ray.direction)));
    return {kUnread, kUnread, way.x, way.y};
}

double GoniometricLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    const TexelLight light = image->at(sphere_to_square(to_local(to_world, ray.direction)));
    return light.luminance / (4 * kPiDouble * image->mean());
}

std::optional<DirectSample> GoniometricLight::sample_direct(const Vec3& point, const Vec2&,
                                                            const SceneSphere&) const {
    const auto way = towards_point(position, point);
    if (!way) return {};
    return sample_at(*way, image->at(sphere_to_square(to_local(to_world, -way->direction))));
}

double GoniometricLight::power(const SceneSphere&) const {
    return 4 * kPiDouble * image->mean();
}

Emission ProjectionLight::sample_emission(const EmissionDimensions& u, const SceneSphere&) const {
    const auto drawn = image->draw({u[2], u[3]});
    const double x = (2 * drawn.place.x - 1) * half.x;
    const double y = (2 * drawn.place.y - 1) * half.y;
    const double intensity = drawn.light.luminance * cosine3(x, y);
    return {position,
            to_world.vector(Vec3d(x, y, 1).normalized()),
            intensity * 4 * half.x * half.y / drawn.density,
            Vec3(0),
            0,
            drawn.light.rgb};
}

/// Returns the image point in the unit square; nothing outside the image.
std::optional<Vec2d> ProjectionLight::place_of(const Vec3d& direction) const {
    const Vec3d w = to_local(to_world, direction);
    if (!(std::abs(w.x) <= half.x * w.z && std::abs(w.y) <= half.y * w.z)) return {};
    return (Vec2d(w.x / (half.x * w.z), w.y / (half.y * w.z)) + Vec2d(1)) / 2;
}

EmissionDimensions ProjectionLight::emission_dimensions(const LightRay& ray,
                                                        const SceneSphere&) const {
    const Vec2d way = image->numbers(place_of(ray.direction).value_or(Vec2d(0.5)));
    return {kUnread, kUnread, way.x, way.y};
}

double ProjectionLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    const auto place = place_of(ray.direction);
    if (!place) return 0;
    const double solid_angle = cosine3((2 * place->x - 1) * half.x, (2 * place->y - 1) * half.y);
    return image->density(*place) / (4 * half.x * half.y * solid_angle);
}

std::optional<DirectSample> ProjectionLight::sample_direct(const Vec3& point, const Vec2&,
                                                           const SceneSphere&) const {
    const auto way = towards_point(position, point);
    if (!way) return {};
    const auto place = place_of(-way->direction);
    if (!place) return {};
    return sample_at(*way, image->at(*place));
}

double ProjectionLight::power(const SceneSphere&) const {
    return 4 * half.x * half.y * image->mean();
}

std::shared_ptr<const LightImage> projected_image(Image image, const Vec2d& half) {
    const Vec2i size = image.resolution();
    // Gauss's rule of three points per axis.
    const double off = std::sqrt(0.15);
    const std::array<Vec2d, 3> rule = {
        {{0.5 - off, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + off, 5.0 / 18}}};
    const auto share = [size, half, rule](int x, int y) {
        double sum = 0;
        for (const Vec2d& along : rule)
            for (const Vec2d& down : rule)
                sum += along.y * down.y *
                       cosine3((2 * (x + along.x) / size.x - 1) * half.x,
                               (2 * (y + down.x) / size.y - 1) * half.y);
        return sum;
    };
    return std::make_shared<const LightImage>(std::move(image), share);
}

}  // namespace sunfleck::engine
