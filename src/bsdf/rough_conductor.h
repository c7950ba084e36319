// RoughConductor: metal with GGX facets on both sides, optionally with energy compensation.
//
// In:  eta + i k per wavelength over the index of air; facets.
// Out: one glossy lobe, and a diffuse one with compensation (bsdf/facet_mirror.h).
#pragma once

#include "bsdf/facet_mirror.h"
#include "bsdf/fresnel.h"

namespace sunfleck::engine {

struct RoughConductor {
    SampledSpectrum eta;
    SampledSpectrum k;
    Ggx facets;
    const FacetLosses* losses = nullptr;  // for energy compensation; null for none

    /// Returns the facets with their reflectance.
    auto mirror() const {
        const auto reflectance = [this](float cosine) {
            return conductor_reflectance(cosine, eta, k);
        };
        return FacetMirror<decltype(reflectance)>{facets, losses, reflectance};
    }

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        return mirror().eval(wo, wi);
    }
    float pdf(const Vec3& wo, const Vec3& wi, Transport) const { return mirror().pdf(wo, wi); }
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        return mirror().sample(wo, draw);
    }

    static constexpr Scattering scattering() { return Scattering::glossy; }
    static bool gathers(float z_from, float z_to) { return z_from * z_to > 0; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }
};

}  // namespace sunfleck::engine
