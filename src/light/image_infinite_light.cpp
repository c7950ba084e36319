// Image infinite light: directions by the luminance of texels, which are of one solid angle.
#include "light/image_infinite_light.h"

#include "light/scene_disc.h"

namespace sunfleck::engine {
namespace {

/// Where on the picture light from a direction of the world is. @param to_world  a rotation.
Vec2d place_of(const Affine& to_world, const Vec3d& w) {
    return sphere_to_square({to_world.x.dot(w), to_world.y.dot(w), to_world.z.dot(w)});
}

}  // namespace

Emission ImageInfiniteLight::sample_emission(const std::array<double, 4>& u,
                                             const SceneSphere& sphere) const {
    const auto drawn = picture->draw({u[2], u[3]});
    const Vec3d direction = -to_world.vector(uniform_sphere(drawn.place));
    return {scene_disc_point(sphere, direction, {u[0], u[1]}),
            direction,
            power(sphere),
            Vec3(0),
            0,
            drawn.light.tint};
}

EmissionDimensions ImageInfiniteLight::emission_dimensions(const LightRay& ray,
                                                           const SceneSphere& sphere) const {
    const Vec2d disc = scene_disc_square(sphere, ray.direction, ray.origin);
    const Vec2d way = picture->numbers(place_of(to_world, -ray.direction));
    return {disc.x, disc.y, way.x, way.y};
}

double ImageInfiniteLight::emission_pdf(const LightRay& ray, const SceneSphere& sphere) const {
    const Vec3 back(-ray.direction);
    return static_cast<double>(beyond(back, back).pdf) / scene_disc_area(sphere);
}

std::optional<DirectSample> ImageInfiniteLight::sample_direct(const Vec3&, const Vec2& u,
                                                              const SceneSphere&) const {
    if (!(picture->mean() > 0)) return {};
    const auto drawn = picture->draw(Vec2d(u));
    const double pdf = drawn.light.luminance / (picture->mean() * 4 * kPiDouble);
    return DirectSample{Vec3(to_world.vector(uniform_sphere(drawn.place))), kInfinity,
                        static_cast<float>(picture->mean() * 4 * kPiDouble),
                        static_cast<float>(pdf), drawn.light.tint};
}

double ImageInfiniteLight::power(const SceneSphere& sphere) const {
    return picture->mean() * 4 * kPiDouble * scene_disc_area(sphere);
}

Beyond ImageInfiniteLight::beyond(const Vec3&, const Vec3& direction) const {
    if (!(picture->mean() > 0)) return {};
    const TexelLight light = picture->at(place_of(to_world, Vec3d(direction)));
    const double pdf = light.luminance / (picture->mean() * 4 * kPiDouble);
    return {static_cast<float>(light.luminance), static_cast<float>(pdf), light.tint};
}

double illuminance_from_above(const LightPicture& picture) {
    const Vec2i& size = picture.resolution();
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double height = uniform_sphere({(x + 0.5) / size.x, (y + 0.5) / size.y}).z;
            if (height > 0) sum += picture.texel(x, y).luminance * height;
        }
    return sum * 4 * kPiDouble / (static_cast<double>(size.x) * size.y);
}

}  // namespace sunfleck::engine
