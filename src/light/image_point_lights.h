// Goniometric and projection lights: points whose intensity an image gives.
//
// Spectrum: radiant intensity for a texel of one, W/sr. Photon directions are sampled by
// brightness.
// Source: pbrt-v4's goniometric and projection lights.
#pragma once

#include "geometry/affine.h"
#include "light/light_image.h"
#include "light/model.h"

#include <memory>

namespace sunfleck::engine {

/// The image is an octahedral equal-area map of directions (uniform_sphere() in math/warp.h).
struct GoniometricLight {
    static constexpr std::string_view name = "goniometric";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    Vec3d position;
    std::shared_ptr<const LightImage> image;
    Affine to_world;  // a rotation, perhaps with a reflection

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const;
};

/// The image lies on the plane z = 1 of the light's frame, x to the right and y down. Within a
/// texel the factor of the emission is proportional to the third power of the cosine.
struct ProjectionLight {
    static constexpr std::string_view name = "projection";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    Vec3d position;
    Vec2d half;                               // half of the image's width and height
    std::shared_ptr<const LightImage> image;  // from projected_image()
    Affine to_world;                          // a rotation, perhaps with a reflection

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const;

private:
    std::optional<Vec2d> place_of(const Vec3d& direction) const;
};

/// Returns an image for a projector, with texels weighted by their solid angles.
std::shared_ptr<const LightImage> projected_image(Image image, const Vec2d& half);

}  // namespace sunfleck::engine
