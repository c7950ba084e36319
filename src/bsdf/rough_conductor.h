// RoughConductor: metal with GGX facets on both sides, optionally with energy compensation.
//
// In:  eta + i k per wavelength over the index of air; facets.
// Out: one glossy lobe, and a diffuse one with compensation.
// Source: Walter et al. 2007, eq. 20; visible normals, Heitz 2018 (bsdf/ggx.h).
#pragma once

#include "bsdf/energy_compensation.h"
#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"
#include "bsdf/lambert.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

struct RoughConductor {
    SampledSpectrum eta;
    SampledSpectrum k;
    Ggx facets;
    const FacetLosses* losses = nullptr;  // for energy compensation; null for none

    /// Returns F D G / (4 |cos| |cos|), which is symmetric and hence the same for both transports.
    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!gathers(wo.z, wi.z) || !(length > 0)) return {};
        const float shape =
            facets.density(sum / length) * facets.shadowing_over_cosines(wo, wi) * 0.25F;
        const SampledSpectrum once =
            conductor_reflectance(std::min(1.0F, 0.5F * length), eta, k) * shape;
        if (losses == nullptr) return once;
        return once + compensation().reflectance(eta, k) * compensation().eval(wo.z, wi.z);
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport) const {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!gathers(wo.z, wi.z) || !(length > 0)) return 0;
        const float once = facets.visible_density_over_cosine(wo, sum / length) * 0.25F;
        if (losses == nullptr) return once;
        const float chance = compensation().lost(wo.z);
        return (1 - chance) * once + chance * std::abs(wi.z) / kPi;
    }

    /// Samples the compensation lobe with the probability that a white metal needs, else the
    /// facets.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        if (wo.z == 0) return {};
        if (losses == nullptr) return sample_facets(wo, draw);
        auto drawn = draw.u.x < compensation().lost(wo.z)
                         ? Lambert{SampledSpectrum(1)}.sample(wo, draw)
                         : sample_facets(wo, draw);
        if (!drawn) return {};
        drawn->pdf = pdf(wo, drawn->wi, draw.transport);
        if (!(*drawn->pdf > 0)) return {};
        drawn->weight = eval(wo, drawn->wi, draw.transport) * (std::abs(drawn->wi.z) / *drawn->pdf);
        return drawn;
    }

    static constexpr Scattering scattering() { return Scattering::glossy; }
    static bool gathers(float z_from, float z_to) { return z_from * z_to > 0; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }

private:
    MetalCompensation compensation() const { return {*losses, facets}; }

    std::optional<BsdfSample> sample_facets(const Vec3& wo, const BsdfSampleInput& draw) const {
        const float side = std::copysign(1.0F, wo.z);
        const Vec3 w = wo * side;
        const Vec3 h = facets.sample_visible(w, draw.u.y, draw.u.z);
        const float cosine = std::min(1.0F, w.dot(h));
        const Vec3 mirrored = h * (2 * cosine) - w;
        if (!(cosine > 0) || !(mirrored.z > 0)) return {};
        return BsdfSample{
            conductor_reflectance(cosine, eta, k) * facets.shadowing_given_masking(w, mirrored),
            mirrored * side, facets.visible_density_over_cosine(w, h) * 0.25F};
    }
};

}  // namespace sunfleck::engine
