// Distant light: parallel rays from the scene disc.
#include "light/distant_light.h"

#include "light/scene_disc.h"

namespace sunfleck::engine {

Emission DistantLight::sample_emission(const EmissionDimensions& u,
                                       const SceneSphere& sphere) const {
    return {scene_disc_point(sphere, direction, {u[0], u[1]}), direction, scene_disc_area(sphere),
            Vec3(0), 0};
}

EmissionDimensions DistantLight::emission_dimensions(const LightRay& ray,
                                                     const SceneSphere& sphere) const {
    const Vec2d disc = scene_disc_square(sphere, direction, ray.origin);
    return {disc.x, disc.y, kUnread, kUnread};
}

double DistantLight::emission_pdf(const LightRay&, const SceneSphere& sphere) const {
    return 1 / scene_disc_area(sphere);
}

std::optional<DirectSample> DistantLight::sample_direct(const Vec3&, const Vec2&,
                                                        const SceneSphere&) const {
    return DirectSample{Vec3(-direction), kInfinity, 1, std::nullopt};
}

double DistantLight::power(const SceneSphere& sphere) const {
    return scene_disc_area(sphere);
}

}  // namespace sunfleck::engine
