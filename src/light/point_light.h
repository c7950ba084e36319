// PointLight: a point with uniform emission in all directions.
//
// Spectrum: radiant intensity, W/sr. Dimensions: direction, equal-area on the sphere.
#pragma once

#include "light/model.h"

namespace sunfleck::engine {

struct PointLight {
    static constexpr std::string_view name = "point";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    Vec3d position;

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay&, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const { return 4 * kPiDouble; }
};

}  // namespace sunfleck::engine
