// DiffuseTransmission: a sheet (paper, leaf, lampshade) that reflects and transmits diffusely.
//
// In:  directions in the local frame (bsdf/model.h).
// Out: f = reflectance / pi on the side of wo, transmittance / pi on the other; symmetric.
#pragma once

#include "bsdf/lambert.h"

namespace sunfleck::engine {

struct DiffuseTransmission {
    SampledSpectrum reflectance;    // per wavelength; the sum with the transmittance is at most one
    SampledSpectrum transmittance;  // per wavelength

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        if (!gathers(wo.z, wi.z)) return {};
        return (wo.z * wi.z > 0 ? reflectance : transmittance) / kPi;
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport) const {
        if (!gathers(wo.z, wi.z)) return 0;
        const float back = chance_back();
        return std::abs(wi.z) / kPi * (wo.z * wi.z > 0 ? back : 1 - back);
    }

    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        const float back = chance_back();
        const bool reflects = draw.u.x < back;
        const float chance = reflects ? back : 1 - back;
        auto drawn = Lambert{(reflects ? reflectance : transmittance) / chance}.sample(wo, draw);
        if (!drawn) return {};
        if (!reflects) drawn->wi.z = -drawn->wi.z;
        *drawn->pdf *= chance;
        return drawn;
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    static bool gathers(float z_from, float z_to) { return z_from != 0 && z_to != 0; }
    SampledSpectrum diffuse_albedo(const Vec3&) const { return reflectance + transmittance; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }

private:
    /// Returns the probability of reflection; never zero or one, because single wavelengths may
    /// differ from the mean.
    float chance_back() const {
        const float back = reflectance.mean();
        const float both = back + transmittance.mean();
        return both > 0 ? std::min(0.99F, std::max(0.01F, back / both)) : 0.5F;
    }
};

}  // namespace sunfleck::engine
