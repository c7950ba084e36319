// CoatedConductor: metal under a clear coat in closed form, exact if both are smooth.
//
// If both are smooth, all inner reflections have one direction: R = F + (1 - F)^2 A^2 r / (1 - F r
// A^2), where F is the reflectance of the coat, r that of the metal, and A the transmittance of one
// way through the coat. Otherwise the lobes are the coat's own reflection, and the metal's lobe
// between the refracted directions times what enters and what leaves. Three approximations apply:
// further inner reflections leave like the first one, a rough coat widens the metal's facets, and
// total reflection inside the coat is lost.
// Source: Airy's sum without phase (Born and Wolf 7.6); widening by added slope variances, in the
// manner of Belcour, Efficient Rendering of Layered Materials (SIGGRAPH 2018).
#pragma once

#include "bsdf/coat_reflection.h"

namespace sunfleck::engine {

class CoatedConductor {
public:
    /// @param eta, k  complex index of the metal over that of the air.
    /// @param facets  of the metal; none if it is smooth.
    CoatedConductor(const SampledSpectrum& eta, const SampledSpectrum& k,
                    const std::optional<Ggx>& facets, const Coat* coat);

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport transport) const;
    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const;
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const;

    Scattering scattering() const { return is_smooth_ ? Scattering::specular : Scattering::glossy; }
    bool gathers(float z_from, float z_to) const { return !is_smooth_ && z_from * z_to > 0; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }

private:
    struct Inner {
        Vec3 w;        // direction within the coat, on the side of the direction in the air
        float passed;  // Coat::entering()
        float coat;  // reflectance of the coat, inner reflections included; the same on both sides
        float attenuation;  // transmittance of one way through the coat
    };

    Inner inner(const Vec3& w) const;
    SampledSpectrum smooth_reflectance(float cosine) const;
    SampledSpectrum metal_eval(const Vec3& wo, const Vec3& wi) const;
    float metal_pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<Vec3> sample_metal(const Vec3& wo, const BsdfSampleInput& draw) const;
    float chance_of_top(const Vec3& wo) const;

    SampledSpectrum eta_;  // over the index of the coat
    SampledSpectrum k_;
    Ggx facets_;
    const Coat* coat_;
    bool is_smooth_;
};

}  // namespace sunfleck::engine
