// Radiance from all directions as a picture has it, from infinitely far away.
//
// Curve: radiance of a texel of value one, W/(sr m^2). The picture is a square, an equal-area
// octahedral map of directions (uniform_sphere() in math/warp.h), z up. Directions are drawn by
// luminance, for photons (which start on the disc of the scene's sphere that is perpendicular to
// them) and for direct light.
// Source: Clarberg, Fast Equal-Area Mapping of the (Hemi)Sphere (2008); pbrt-v4's lights.
#pragma once

#include "geometry/affine.h"
#include "light/light_picture.h"
#include "light/model.h"

#include <memory>

namespace sunfleck::engine {

struct ImageInfiniteLight {
    static constexpr std::string_view name = "infinite with a picture";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;
    std::shared_ptr<const LightPicture> picture;
    Affine to_world;  // a rotation, or one with a reflection

    Emission sample_emission(const std::array<double, 4>& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere& sphere) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    double power(const SceneSphere& sphere) const;
    Beyond beyond(const Vec3& from, const Vec3& direction) const;
};

/// Illuminance on the plane z = 0 from above, for a picture of all directions: lumens per m^2 if
/// its texels are nits.
double illuminance_from_above(const LightPicture& picture);

}  // namespace sunfleck::engine
