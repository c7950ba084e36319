// What a clear coat reflects itself; what it lets through is lost here.
//
// In:  a coat. Out: one lobe, on both sides alike: a delta lobe, or a glossy one if it is rough.
// Source: Fresnel; Walter et al. 2007, eq. 20; visible normals, Heitz 2018 (bsdf/ggx.h).
#pragma once

#include "bsdf/coat.h"
#include "bsdf/model.h"

namespace sunfleck {

struct CoatReflection {
    const Coat* coat;  // its material's: outlives all that scatters from it

    Spectrum eval(const Vec3& w_from, const Vec3& w_to, Transport) const {
        const Vec3 sum = w_from + w_to;
        const float length = sum.length();
        if (!gathers(w_from.z, w_to.z) || !(length > 0)) return {};
        const Ggx& facets = *coat->facets();
        return Spectrum(coat->reflectance(std::min(1.0F, 0.5F * length)) *
                        facets.density(sum / length) * facets.shadowing_over_cosines(w_from, w_to) *
                        0.25F);
    }

    float pdf(const Vec3& w_from, const Vec3& w_to, Transport) const {
        const Vec3 sum = w_from + w_to;
        const float length = sum.length();
        if (!gathers(w_from.z, w_to.z) || !(length > 0)) return 0;
        return coat->facets()->visible_density_over_cosine(w_from, sum / length) * 0.25F;
    }

    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw& draw) const {
        if (w_from.z == 0) return {};
        if (!coat->facets())
            return BsdfSample{Spectrum(coat->reflectance(std::min(1.0F, std::abs(w_from.z)))),
                              Vec3(-w_from.x, -w_from.y, w_from.z),
                              {}};
        const Ggx& facets = *coat->facets();
        const float side = std::copysign(1.0F, w_from.z);
        const Vec3 w = w_from * side;
        const Vec3 h = facets.sample_visible(w, draw.u.y, draw.u.z);
        const float cosine = std::min(1.0F, w.dot(h));
        const Vec3 mirrored = h * (2 * cosine) - w;
        if (!(cosine > 0) || !(mirrored.z > 0)) return {};
        return BsdfSample{
            Spectrum(coat->reflectance(cosine) * facets.shadowing_given_masking(w, mirrored)),
            mirrored * side, facets.visible_density_over_cosine(w, h) * 0.25F};
    }

    Scattering scattering() const {
        return coat->facets() ? Scattering::glossy : Scattering::specular;
    }
    bool gathers(float z_from, float z_to) const { return coat->facets() && z_from * z_to > 0; }
};

}  // namespace sunfleck
