// RoughDielectric: rough glass; each facet of a GGX distribution reflects and refracts.
//
// In:  eta per wavelength, index inside (side -z) over outside (side +z); facets.
// Out: two glossy lobes, and diffuse ones with energy compensation (bsdf/energy_compensation.h);
// without it, light from facet to facet is lost.
// Source: Walter et al., Microfacet Models for Refraction through Rough Surfaces (EGSR 2007), eq.
// 16, 17, 20, 21; visible normals, Heitz 2018 (bsdf/ggx.h).
#pragma once

#include "bsdf/energy_compensation.h"
#include "bsdf/ggx.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

class RoughDielectric {
public:
    /// @param eta  positive; no wavelength within kLeastContrast of 1, where nothing is refracted
    /// and the lobe has no density (SmoothDielectric handles that).
    /// @param losses  for energy compensation; null for none. It outlives this BSDF.
    RoughDielectric(const SampledSpectrum& eta, const Ggx& facets,
                    const FacetLosses* losses = nullptr)
        : eta_(eta), facets_(facets), losses_(losses), dispersive_(eta.min() != eta.max()) {}

    static constexpr float kLeastContrast = 1e-3F;

    /// Returns f, exact in every wavelength, dispersive or not.
    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport transport) const;

    /// Returns the density of sample(). If dispersive, it is the mean over hero wavelengths. MIS
    /// weights take at_wavelength() first, because both techniques then know the wavelength.
    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const;

    /// Reflects with the facet's Fresnel reflectance, else refracts. If dispersive, wavelength
    /// draw.hero.chosen decides the direction; unless hero.single, the sample terminates the
    /// secondary wavelengths: weight and pdf are those of at_wavelength(), the weight times
    /// kWavelengths.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const;

    static constexpr Scattering scattering() { return Scattering::glossy; }
    static bool gathers(float z_from, float z_to) { return z_from != 0 && z_to != 0; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }

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
