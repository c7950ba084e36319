// FacetMirror: reflection by GGX facets on both sides, for any reflectance of a facet, optionally
// with energy compensation.
//
// Source: Walter et al. 2007, eq. 20; visible normals, Heitz 2018 (bsdf/ggx.h).
#pragma once

#include "bsdf/energy_compensation.h"
#include "bsdf/ggx.h"
#include "bsdf/lambert.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

/// @tparam Reflectance  returns the reflectance of a facet, per wavelength, by the cosine in (0,1].
template <class Reflectance>
struct FacetMirror {
    Ggx facets;
    const FacetLosses* losses;  // for energy compensation; null for none
    Reflectance reflectance;

    /// Returns F D G / (4 |cos| |cos|), which is symmetric and hence the same for both transports.
    SampledSpectrum eval(const Vec3& wo, const Vec3& wi) const {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!(wo.z * wi.z > 0) || !(length > 0)) return {};
        const float shape =
            facets.density(sum / length) * facets.shadowing_over_cosines(wo, wi) * 0.25F;
        const SampledSpectrum once = reflectance(std::min(1.0F, 0.5F * length)) * shape;
        if (losses == nullptr) return once;
        return once + compensation().reflectance(reflectance) * compensation().eval(wo.z, wi.z);
    }

    float pdf(const Vec3& wo, const Vec3& wi) const {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!(wo.z * wi.z > 0) || !(length > 0)) return 0;
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
        drawn->pdf = pdf(wo, drawn->wi);
        if (!(*drawn->pdf > 0)) return {};
        drawn->weight = eval(wo, drawn->wi) * (std::abs(drawn->wi.z) / *drawn->pdf);
        return drawn;
    }

private:
    MetalCompensation compensation() const { return {*losses, facets}; }

    std::optional<BsdfSample> sample_facets(const Vec3& wo, const BsdfSampleInput& draw) const {
        const float side = std::copysign(1.0F, wo.z);
        const Vec3 w = wo * side;
        const Vec3 h = facets.sample_visible(w, draw.u.y, draw.u.z);
        const float cosine = std::min(1.0F, w.dot(h));
        const Vec3 mirrored = h * (2 * cosine) - w;
        if (!(cosine > 0) || !(mirrored.z > 0)) return {};
        return BsdfSample{reflectance(cosine) * facets.shadowing_given_masking(w, mirrored),
                          mirrored * side, facets.visible_density_over_cosine(w, h) * 0.25F};
    }
};

}  // namespace sunfleck::engine
