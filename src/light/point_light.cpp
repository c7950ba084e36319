// Point light: uniform emission, inverse square law.
#include "light/point_light.h"

#include "light/towards_point.h"
#include "math/warp.h"

namespace sunfleck::engine {

Emission PointLight::sample_emission(const EmissionDimensions& u, const SceneSphere&) const {
    return {position, uniform_sphere({u[2], u[3]}), 4 * kPiDouble, Vec3(0), 0};
}

EmissionDimensions PointLight::emission_dimensions(const LightRay& ray, const SceneSphere&) const {
    const Vec2d way = sphere_to_square(ray.direction);
    return {kUnread, kUnread, way.x, way.y};
}

double PointLight::emission_pdf(const LightRay&, const SceneSphere&) const {
    return 1 / (4 * kPiDouble);
}

std::optional<DirectSample> PointLight::sample_direct(const Vec3& point, const Vec2&,
                                                      const SceneSphere&) const {
    const auto way = towards_point(position, point);
    if (!way) return {};
    return DirectSample{Vec3(way->direction), static_cast<float>(way->distance),
                        static_cast<float>(1 / way->distance2), std::nullopt};
}

}  // namespace sunfleck::engine
