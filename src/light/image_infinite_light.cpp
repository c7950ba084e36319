// Environment map: directions by the luminance of texels, which have equal solid angles.
#include "light/image_infinite_light.h"

#include "light/scene_disc.h"

namespace sunfleck::engine {
namespace {

/// Returns the image point for light from a world direction. @param to_world  a rotation.
Vec2d place_of(const Affine& to_world, const Vec3d& w) {
    return sphere_to_square({to_world.x.dot(w), to_world.y.dot(w), to_world.z.dot(w)});
}

}  // namespace

Emission ImageInfiniteLight::sample_emission(const std::array<double, 4>& u,
                                             const SceneSphere& sphere) const {
    const auto drawn = image->draw({u[2], u[3]});
    const Vec3d direction = -to_world.vector(uniform_sphere(drawn.place));
    return {scene_disc_point(sphere, direction, {u[0], u[1]}),
            direction,
            power(sphere),
            Vec3(0),
            0,
            drawn.light.rgb};
}

EmissionDimensions ImageInfiniteLight::emission_dimensions(const LightRay& ray,
                                                           const SceneSphere& sphere) const {
    const Vec2d disc = scene_disc_square(sphere, ray.direction, ray.origin);
    const Vec2d way = image->numbers(place_of(to_world, -ray.direction));
    return {disc.x, disc.y, way.x, way.y};
}

double ImageInfiniteLight::emission_pdf(const LightRay& ray, const SceneSphere& sphere) const {
    const Vec3 back(-ray.direction);
    return static_cast<double>(environment_radiance(back, back).pdf) / scene_disc_area(sphere);
}

std::optional<DirectSample> ImageInfiniteLight::sample_direct(const Vec3&, const Vec2& u,
                                                              const SceneSphere&) const {
    if (!(image->mean() > 0)) return {};
    const auto drawn = image->draw(Vec2d(u));
    const double pdf = drawn.light.luminance / (image->mean() * 4 * kPiDouble);
    return DirectSample{Vec3(to_world.vector(uniform_sphere(drawn.place))), kInfinity,
                        static_cast<float>(image->mean() * 4 * kPiDouble), static_cast<float>(pdf),
                        drawn.light.rgb};
}

double ImageInfiniteLight::power(const SceneSphere& sphere) const {
    return image->mean() * 4 * kPiDouble * scene_disc_area(sphere);
}

EnvironmentRadiance ImageInfiniteLight::environment_radiance(const Vec3&,
                                                             const Vec3& direction) const {
    if (!(image->mean() > 0)) return {};
    const TexelLight light = image->at(place_of(to_world, Vec3d(direction)));
    const double pdf = light.luminance / (image->mean() * 4 * kPiDouble);
    return {static_cast<float>(light.luminance), static_cast<float>(pdf), light.rgb};
}

double illuminance_from_above(const LightImage& image) {
    const Vec2i& size = image.resolution();
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double height = uniform_sphere({(x + 0.5) / size.x, (y + 0.5) / size.y}).z;
            if (height > 0) sum += image.texel(x, y).luminance * height;
        }
    return sum * 4 * kPiDouble / (static_cast<double>(size.x) * size.y);
}

}  // namespace sunfleck::engine
