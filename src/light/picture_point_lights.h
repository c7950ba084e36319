// Points that emit as a picture says: over all directions, or as a projector.
//
// Curve: radiant intensity where a texel is one, W/sr. Photons go where the picture is bright.
// Source: pbrt-v4's goniometric and projection lights.
#pragma once

#include "geometry/affine.h"
#include "light/light_picture.h"
#include "light/model.h"

#include <memory>

namespace sunfleck::engine {

/// The picture is an equal-area octahedral map of directions (uniform_sphere() in math/warp.h).
struct GoniometricLight {
    static constexpr std::string_view name = "goniometric";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    Vec3d position;
    std::shared_ptr<const LightPicture> picture;
    Affine to_world;  // a rotation, or one with a reflection

    Emission sample_emission(const std::array<double, 4>& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const;
};

/// The picture lies on the plane z = 1 of the light's frame, x to the right and y down. Within a
/// texel the factor of emission follows the third power of the cosine.
struct ProjectionLight {
    static constexpr std::string_view name = "projection";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    Vec3d position;
    Vec2d half;                                   // of the picture's width and height
    std::shared_ptr<const LightPicture> picture;  // of projected_picture()
    Affine to_world;                              // as above

    Emission sample_emission(const std::array<double, 4>& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const;

private:
    std::optional<Vec2d> place_of(const Vec3d& direction) const;
};

/// A picture for a projector, texels weighed by their solid angles.
std::shared_ptr<const LightPicture> projected_picture(Image image, const Vec2d& half);

}  // namespace sunfleck::engine
