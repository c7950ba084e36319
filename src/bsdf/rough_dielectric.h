// Rough glass: a boundary of small facets (GGX), each of which reflects and refracts.
//
// In:  eta per lane, index inside (side -z) over outside (side +z); facets. Out: two glossy lobes,
// and wide ones where losses are given back.
// Source: Walter et al., Microfacet Models for Refraction through Rough Surfaces (EGSR 2007),
// eq. 16, 17, 20, 21; visible normals, Heitz 2018 (bsdf/ggx.h). Light that leaves a facet towards
// another is lost, or given back by bsdf/energy_compensation.h.
#pragma once

#include "bsdf/energy_compensation.h"
#include "bsdf/ggx.h"
#include "bsdf/model.h"

namespace sunfleck {

class RoughDielectric {
public:
    /// @param eta  positive; no lane within kLeastContrast of 1, where nothing is refracted and
    ///             the lobe has no density: that is a SmoothDielectric.
    /// @param losses  given back; null: they are lost. Outlives this.
    RoughDielectric(const Spectrum& eta, const Ggx& facets, const FacetLosses* losses = nullptr)
        : eta_(eta), facets_(facets), losses_(losses), dispersive_(eta.min() != eta.max()) {}

    static constexpr float kLeastContrast = 1e-3F;

    /// Right in every lane, dispersive or not.
    Spectrum eval(const Vec3& w_from, const Vec3& w_to, Transport transport) const;

    /// Dispersive: the mean over lanes, which is the density of sample() over all choices of lane.
    /// Who weighs sample() against another technique takes for_lane() first, for then both know
    /// the lane.
    float pdf(const Vec3& w_from, const Vec3& w_to, Transport transport) const;

    /// Reflects with the facet's Fresnel reflectance. Dispersive: bends as lane
    /// draw.lanes.chosen does; unless lanes.single, the sample is dispersed, with that lane alone
    /// in the weight and that lane's own pdf: as for_lane() gives, times kLanes.
    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw& draw) const;

    static constexpr Scattering scattering() { return Scattering::glossy; }
    static bool gathers(float z_from, float z_to) { return z_from != 0 && z_to != 0; }

    const Spectrum& eta() const { return eta_; }
    const Ggx& facets() const { return facets_; }
    bool is_dispersive() const { return dispersive_; }
    RoughDielectric for_lane(std::size_t lane) const {
        return {Spectrum(eta_[lane]), facets_, losses_};
    }

private:
    Spectrum eta_;
    Ggx facets_;
    const FacetLosses* losses_;
    bool dispersive_;
};

}  // namespace sunfleck
