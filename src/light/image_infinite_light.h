// ImageInfiniteLight: an environment map, radiance from all directions given by an image.
//
// Spectrum: radiance of a texel of value one, W/(sr m^2). Directions are sampled by luminance, for
// photons (which start on the disc of the scene sphere perpendicular to the direction) and for
// direct light.
#pragma once

#include "geometry/affine.h"
#include "light/direction_map.h"
#include "light/light_image.h"
#include "light/model.h"

#include <memory>

namespace sunfleck::engine {

struct ImageInfiniteLight {
    static constexpr std::string_view name = "infinite with a picture";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;
    std::shared_ptr<const LightImage> image;
    Affine to_world;  // a rotation, perhaps with a reflection
    DirectionMap map{};

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere& sphere) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    double power(const SceneSphere& sphere) const;
    EnvironmentRadiance environment_radiance(const Vec3& from, const Vec3& direction) const;
};

/// Returns an image as light of the directions that `map` gives its texels.
std::shared_ptr<const LightImage> image_of_directions(Image image, const DirectionMap& map);

/// Returns the illuminance on the plane z = 0 from above: in lumens per m^2 if texels are in nits.
double illuminance_from_above(const LightImage& image, const DirectionMap& map);

}  // namespace sunfleck::engine
