// Constant environment: uniform directions, each from the scene disc.
#include "light/infinite_light.h"

#include "light/scene_disc.h"

namespace sunfleck::engine {

Emission InfiniteLight::sample_emission(const EmissionDimensions& u,
                                        const SceneSphere& sphere) const {
    const Vec3d direction = uniform_sphere({u[2], u[3]});
    return {scene_disc_point(sphere, direction, {u[0], u[1]}), direction, power(sphere), Vec3(0),
            0};
}

EmissionDimensions InfiniteLight::emission_dimensions(const LightRay& ray,
                                                      const SceneSphere& sphere) const {
    const Vec2d disc = scene_disc_square(sphere, ray.direction, ray.origin);
    const Vec2d way = sphere_to_square(ray.direction);
    return {disc.x, disc.y, way.x, way.y};
}

double InfiniteLight::emission_pdf(const LightRay&, const SceneSphere& sphere) const {
    return 1 / power(sphere);
}

std::optional<DirectSample> InfiniteLight::sample_direct(const Vec3& point, const Vec2& u,
                                                         const SceneSphere&) const {
    const Vec3 direction(uniform_sphere(Vec2d(u)));
    return DirectSample{direction, kInfinity, 4 * kPi, environment_radiance(point, direction).pdf};
}

double InfiniteLight::power(const SceneSphere& sphere) const {
    return 4 * kPiDouble * scene_disc_area(sphere);
}

EnvironmentRadiance InfiniteLight::environment_radiance(const Vec3&, const Vec3&) const {
    return {1, 1 / (4 * kPi)};
}

}  // namespace sunfleck::engine
