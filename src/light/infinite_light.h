// InfiniteLight: constant radiance from all directions, infinitely far away.
//
// Spectrum: radiance, W/(sr m^2). Directions are uniform on the sphere, for photons (which start on
// the disc of the scene sphere perpendicular to the direction) and for direct light.
#pragma once

#include "light/model.h"

namespace sunfleck::engine {

struct InfiniteLight {
    static constexpr std::string_view name = "infinite";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay&, const SceneSphere& sphere) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    double power(const SceneSphere& sphere) const;
    EnvironmentRadiance environment_radiance(const Vec3& from, const Vec3& direction) const;
};

}  // namespace sunfleck::engine
