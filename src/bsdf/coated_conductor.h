// Metal under a clear coat, in closed form: exact where both are smooth, close where one is rough.
//
// Smooth on smooth, all inner reflections go one way: R = F + (1 - F)^2 A^2 r / (1 - F r A^2), with
// F the coat's and r the metal's reflectance and A the light left after one way through the coat.
// Else the coat's own reflection, and the metal's lobe between the refracted directions, times what
// enters and what leaves; further inner reflections are taken to leave as the first one does, a
// rough coat widens the metal's facets, and light that meets the coat from below beyond the
// critical angle is lost.
// Source: Airy's sum without phase (Born and Wolf 7.6); the widening by adding variances of slopes,
// in the manner of Belcour, Efficient Rendering of Layered Materials (SIGGRAPH 2018).
#pragma once

#include "bsdf/coat_reflection.h"

namespace sunfleck::engine {

class CoatedConductor {
public:
    /// @param eta, k  of the metal over the air. @param facets  of the metal; none: smooth.
    CoatedConductor(const SampledSpectrum& eta, const SampledSpectrum& k,
                    const std::optional<Ggx>& facets, const Coat* coat);

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport transport) const;
    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const;
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfDraw& draw) const;

    Scattering scattering() const { return is_smooth_ ? Scattering::specular : Scattering::glossy; }
    bool gathers(float z_from, float z_to) const { return !is_smooth_ && z_from * z_to > 0; }
    static SampledSpectrum spread_share(const Vec3&) { return {}; }
    static constexpr float mirror_share(const Vec3&, const HeroWavelength&) { return 0; }

private:
    struct Inner {
        Vec3 w;             // within the coat, on the side of the direction in the air
        float passed;       // Coat::entering()
        float coat;         // its reflectance, inner reflection included: the same on both sides
        float attenuation;  // what one way through leaves
    };

    Inner inner(const Vec3& w) const;
    SampledSpectrum smooth_reflectance(float cosine) const;
    SampledSpectrum metal_eval(const Vec3& wo, const Vec3& wi) const;
    float metal_pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<Vec3> sample_metal(const Vec3& wo, const BsdfDraw& draw) const;
    float chance_of_top(const Vec3& wo) const;

    SampledSpectrum eta_;  // over the coat's
    SampledSpectrum k_;
    Ggx facets_;
    const Coat* coat_;
    bool is_smooth_;
};

}  // namespace sunfleck::engine
