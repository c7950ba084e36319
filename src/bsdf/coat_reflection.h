// CoatReflection: the reflection of a clear coat alone; light that it transmits is absorbed.
//
// In:  a coat. Out: one lobe, the same on both sides: a delta lobe if smooth, glossy if rough.
// Source: Fresnel; Walter et al. 2007, eq. 20; visible normals, Heitz 2018 (bsdf/ggx.h).
#pragma once

#include "bsdf/coat.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

struct CoatReflection {
    const Coat* coat;  // owned by the material, which outlives the BSDF

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!gathers(wo.z, wi.z) || !(length > 0)) return {};
        const Ggx& facets = *coat->facets();
        return SampledSpectrum(coat->reflectance(std::min(1.0F, 0.5F * length)) *
                               facets.density(sum / length) *
                               facets.shadowing_over_cosines(wo, wi) * 0.25F);
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport) const {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!gathers(wo.z, wi.z) || !(length > 0)) return 0;
        return coat->facets()->visible_density_over_cosine(wo, sum / length) * 0.25F;
    }

    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        if (wo.z == 0) return {};
        if (!coat->facets())
            return BsdfSample{SampledSpectrum(coat->reflectance(std::min(1.0F, std::abs(wo.z)))),
                              Vec3(-wo.x, -wo.y, wo.z),
                              {}};
        const Ggx& facets = *coat->facets();
        const float side = std::copysign(1.0F, wo.z);
        const Vec3 w = wo * side;
        const Vec3 h = facets.sample_visible(w, draw.u.y, draw.u.z);
        const float cosine = std::min(1.0F, w.dot(h));
        const Vec3 mirrored = h * (2 * cosine) - w;
        if (!(cosine > 0) || !(mirrored.z > 0)) return {};
        return BsdfSample{SampledSpectrum(coat->reflectance(cosine) *
                                          facets.shadowing_given_masking(w, mirrored)),
                          mirrored * side, facets.visible_density_over_cosine(w, h) * 0.25F};
    }

    Scattering scattering() const {
        return coat->facets() ? Scattering::glossy : Scattering::specular;
    }
    bool gathers(float z_from, float z_to) const { return coat->facets() && z_from * z_to > 0; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }
};

}  // namespace sunfleck::engine
