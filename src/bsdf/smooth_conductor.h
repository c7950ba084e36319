// SmoothConductor: polished metal, a mirror on both sides coloured by its complex index.
//
// In:  eta + i k per wavelength over the index of air. Out: one delta lobe.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

struct SmoothConductor {
    SampledSpectrum eta;
    SampledSpectrum k;

    static SampledSpectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput&) const {
        if (wo.z == 0) return {};
        return BsdfSample{
            conductor_reflectance(std::abs(wo.z), eta, k), Vec3(-wo.x, -wo.y, wo.z), {}};
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }
};

}  // namespace sunfleck::engine
