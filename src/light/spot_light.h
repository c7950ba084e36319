// SpotLight: a point that emits into a cone with a soft edge, pbrt-v4's or glTF's.
//
// Spectrum: radiant intensity on the axis, W/sr. Photon directions are sampled exactly by
// intensity, so that Emission::factor is the power. They change fast with the dimensions at the
// cone's edge alone.
#pragma once

#include "light/model.h"

namespace sunfleck::engine {

/// How the intensity decreases over the edge: with t, which is linear in the cosine and decreases
/// from 1 to 0.
enum class SpotEdge {
    smoothstep,  // t^2 (3 - 2 t), pbrt-v4
    square       // t^2, KHR_lights_punctual of glTF
};

struct SpotLight {
    static constexpr std::string_view name = "spot";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    Vec3d position;
    Vec3d axis;            // unit
    double cos_total = 0;  // no light outside
    double cos_start = 1;  // full intensity inside; the edge is in between
    SpotEdge edge = SpotEdge::smoothstep;

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2&,
                                              const SceneSphere&) const;
    /// Returns 2 pi ((1 - cos_start) + (cos_start - cos_total) m), where m, the mean over the edge,
    /// is 1/2 for the smoothstep and 1/3 for the square: exact.
    double power(const SceneSphere&) const;
    /// Returns the intensity over that on the axis, in [0,1]. @param cos_angle  of direction and
    /// axis.
    double falloff(double cos_angle) const;
};

}  // namespace sunfleck::engine
