// Rough glass: a boundary of small facets (GGX), each of which reflects and refracts.
//
// In:  eta per wavelength, index inside (side -z) over outside (side +z); facets. Out: two glossy
// lobes, and wide ones where losses are given back. Source: Walter et al., Microfacet Models for
// Refraction through Rough Surfaces (EGSR 2007), eq. 16, 17, 20, 21; visible normals, Heitz 2018
// (bsdf/ggx.h). Light that leaves a facet towards another is lost, or given back by
// bsdf/energy_compensation.h.
#pragma once

#include "bsdf/energy_compensation.h"
#include "bsdf/ggx.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

class RoughDielectric {
public:
    /// @param eta  positive; no wavelength within kLeastContrast of 1, where nothing is refracted
    /// and
    ///             the lobe has no density: that is a SmoothDielectric.
    /// @param losses  given back; null: they are lost. Outlives this.
    RoughDielectric(const SampledSpectrum& eta, const Ggx& facets,
                    const FacetLosses* losses = nullptr)
        : eta_(eta), facets_(facets), losses_(losses), dispersive_(eta.min() != eta.max()) {}

    static constexpr float kLeastContrast = 1e-3F;

    /// Right in every wavelength, dispersive or not.
    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport transport) const;

    /// Dispersive: the mean over wavelengths, which is the density of sample() over all choices of
    /// wavelength. Who weighs sample() against another technique takes at_wavelength() first, for
    /// then both know the wavelength.
    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const;

    /// Reflects with the facet's Fresnel reflectance. Dispersive: bends as wavelength
    /// draw.hero.chosen does; unless hero.single, the sample is dispersed, with that wavelength
    /// alone in the weight and that wavelength's own pdf: as at_wavelength() gives, times
    /// kWavelengths.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfDraw& draw) const;

    static constexpr Scattering scattering() { return Scattering::glossy; }
    static bool gathers(float z_from, float z_to) { return z_from != 0 && z_to != 0; }
    static SampledSpectrum spread_share(const Vec3&) { return {}; }
    static constexpr float mirror_share(const Vec3&, const HeroWavelength&) { return 0; }

    const SampledSpectrum& eta() const { return eta_; }
    const Ggx& facets() const { return facets_; }
    bool is_dispersive() const { return dispersive_; }
    RoughDielectric at_wavelength(std::size_t wavelength) const {
        return {SampledSpectrum(eta_[wavelength]), facets_, losses_};
    }

private:
    SampledSpectrum eta_;
    Ggx facets_;
    const FacetLosses* losses_;
    bool dispersive_;
};

}  // namespace sunfleck::engine
