// DistantLight: parallel light from infinitely far away.
//
// Spectrum: irradiance on a plane perpendicular to the direction, W/m^2. Photons start on a disc of
// the scene sphere's radius, perpendicular to the direction, one radius before its centre.
#pragma once

#include "light/model.h"

namespace sunfleck::engine {

struct DistantLight {
    static constexpr std::string_view name = "distant";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;
    Vec3d direction;  // unit; direction in which the light travels

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay&, const SceneSphere& sphere) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    double power(const SceneSphere& sphere) const;
};

}  // namespace sunfleck::engine
