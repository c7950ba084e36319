// Environment map: directions by the luminance of texels, weighted with their solid angles.
#include "light/image_infinite_light.h"

#include "light/scene_disc.h"

namespace sunfleck::engine {
namespace {

/// Returns the image point for light from a world direction.
Vec2d place_of(const ImageInfiniteLight& light, const Vec3d& w) {
    const Affine& frame = light.to_world;
    return light.map.place({frame.x.dot(w), frame.y.dot(w), frame.z.dot(w)});
}

}  // namespace

Emission ImageInfiniteLight::sample_emission(const EmissionDimensions& u,
                                             const SceneSphere& sphere) const {
    const auto drawn = image->draw({u[2], u[3]});
    const Vec3d direction = -to_world.vector(map.direction(drawn.place));
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
    const Vec2d way = image->numbers(place_of(*this, -ray.direction));
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
    return DirectSample{Vec3(to_world.vector(map.direction(drawn.place))), kInfinity,
                        static_cast<float>(image->mean() * 4 * kPiDouble), static_cast<float>(pdf),
                        drawn.light.rgb};
}

double ImageInfiniteLight::power(const SceneSphere& sphere) const {
    return image->mean() * 4 * kPiDouble * scene_disc_area(sphere);
}

EnvironmentRadiance ImageInfiniteLight::environment_radiance(const Vec3&,
                                                             const Vec3& direction) const {
    if (!(image->mean() > 0)) return {};
    const TexelLight light = image->at(place_of(*this, Vec3d(direction)));
    const double pdf = light.luminance / (image->mean() * 4 * kPiDouble);
    return {static_cast<float>(light.luminance), static_cast<float>(pdf), light.rgb};
}

std::shared_ptr<const LightImage> image_of_directions(Image image, const DirectionMap& map) {
    if (map.has_equal_areas()) return std::make_shared<const LightImage>(std::move(image));
    return std::make_shared<const LightImage>(std::move(image),
                                              [&](int, int y) { return map.share(y); });
}

double illuminance_from_above(const LightImage& image, const DirectionMap& map) {
    const Vec2i& size = image.resolution();
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double height = map.direction({(x + 0.5) / size.x, (y + 0.5) / size.y}).z;
            if (height > 0) sum += image.texel(x, y).luminance * height * map.share(y);
        }
    return sum * 4 * kPiDouble / (static_cast<double>(size.x) * size.y);
}

}  // namespace sunfleck::engine
