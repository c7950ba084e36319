// A disc of directions, by the concentric map.
#include "light/sun_light.h"

#include "light/scene_disc.h"

namespace sunfleck::engine {

double SunLight::brightness(double radius2) const {
    return horner(darkening, std::sqrt(std::max(0.0, 1 - radius2)));
}

Emission SunLight::sample_emission(const EmissionDimensions& u, const SceneSphere& sphere) const {
    const DiscPoint disc = concentric_disc_point({u[2], u[3]});
    const Vec3d way = rotate_z_to(direction, around_pole(disc, disc.radius2 * versine));
    return {scene_disc_point(sphere, way, {u[0], u[1]}), way,
            scene_disc_area(sphere) * brightness(disc.radius2), Vec3(0), 0};
}

EmissionDimensions SunLight::emission_dimensions(const LightRay& ray,
                                                 const SceneSphere& sphere) const {
    const Vec2d origin = scene_disc_square(sphere, ray.direction, ray.origin);
    const Vec3d local = rotate_to_z(direction, ray.direction);
    const double flat2 = local.x * local.x + local.y * local.y;
    const double stretch = std::sqrt(1 / (versine * (1 + local.z)));  // radius / sqrt(flat2)
    const Vec2d way = flat2 > 0 ? disc_to_square(Vec2d(local.x, local.y) * stretch) : Vec2d(0.5);
    return {origin.x, origin.y, way.x, way.y};
}

double SunLight::emission_pdf(const LightRay&, const SceneSphere& sphere) const {
    return 1 / (solid_angle() * scene_disc_area(sphere));
}

std::optional<DirectSample> SunLight::sample_direct(const Vec3&, const Vec2& u,
                                                    const SceneSphere&) const {
    const DiscPoint disc = concentric_disc_point(Vec2d(u));
    const Vec3d way = rotate_z_to(direction, around_pole(disc, disc.radius2 * versine));
    return DirectSample{Vec3(-way), kInfinity, static_cast<float>(brightness(disc.radius2)),
                        static_cast<float>(1 / solid_angle())};
}

double SunLight::power(const SceneSphere& sphere) const {
    return scene_disc_area(sphere);
}

EnvironmentRadiance SunLight::environment_radiance(const Vec3&, const Vec3& towards) const {
    const Vec3d chord = Vec3d(towards) + direction;  // its square is twice the versine
    const double radius2 = chord.dot(chord) / (2 * versine);
    if (!(radius2 < 1)) return {};
    const double pdf = 1 / solid_angle();
    return {static_cast<float>(brightness(radius2) * pdf), static_cast<float>(pdf)};
}

std::array<double, 6> normalised_darkening(std::array<double, 6> coefficients) {
    double mean = 0;  // that of the cosine's power k over a disc is 2 / (k + 2)
    for (std::size_t k = 0; k < coefficients.size(); ++k)
        mean += coefficients[k] * 2 / (static_cast<double>(k) + 2);
    for (double& c : coefficients) c /= mean;
    return coefficients;
}

}  // namespace sunfleck::engine
