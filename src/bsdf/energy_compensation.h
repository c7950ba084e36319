// Energy compensation for rough metal and glass: diffuse lobes for light that single scattering
// loses.
//
// In:  facets, and cosines with the normal. Out: f, and the probability and density of its
// sampling.
// Source: Kulla and Conty 2017 (bsdf/facet_losses.h); the division of glass into two sides is ours.
//
// Glass, with n the index and A the mean loss on a side: f(a -> b) = n_b^2 k L(a) L(b) / pi is
// reciprocal with one k per pair of sides. All energy is restored if a fraction t = k n^2 A (of the
// other side) is transmitted and 1 - t reflected. k is the largest value for which neither side
// transmits more diffuse light than a smooth boundary does.
#pragma once

#include "bsdf/facet_losses.h"
#include "bsdf/fresnel.h"

namespace sunfleck::engine {

struct MetalCompensation {
    const FacetLosses& losses;
    const Ggx& facets;

    float lost(float z) const { return losses.of_mirror(facets, std::abs(z)); }

    /// Returns the fraction of a first facet's losses that further facets reflect, with their
    /// colour.
    /// @param facet  returns the reflectance of a facet by its cosine.
    template <class Reflectance>
    SampledSpectrum reflectance(const Reflectance& facet) const {
        // Gauss's rule of four points over the squared cosine, which is uniform for diffuse light.
        const SampledSpectrum mean = 0.1739274F * (facet(0.2634992F) + facet(0.9646596F)) +
                                     0.3260726F * (facet(0.5744645F) + facet(0.8185295F));
        const float lost_again = losses.mean_of_mirror(facets);
        return mean * mean * (1 - lost_again) / (SampledSpectrum(1) - mean * lost_again);
    }

    /// Returns f for a reflectance() of one.
    float eval(float z_from, float z_to) const {
        return lost(z_from) * lost(z_to) / (kPi * losses.mean_of_mirror(facets));
    }
};

struct GlassCompensation {
    const FacetLosses& losses;
    const Ggx& facets;
    float eta;  // index inside (side -z) over outside

    /// @param z  cosine of a direction; its sign selects the side.
    float lost(float z) const { return losses.of_glass(facets, std::abs(z), far_over_near(z)); }
    float mean_lost(float z) const { return losses.mean_of_glass(facets, far_over_near(z)); }

    /// Returns the fraction of the losses on the side of z that is transmitted to the other side.
    float passing(float z) const {
        const float here = mean_lost(z);
        const float there = mean_lost(-z);
        const float smooth = 1 - mean_dielectric_reflectance(far_over_near(z));
        return smooth * there / std::max(here, there);
    }

    /// Returns f; for transmission, f over the squared index of the side of z_to.
    float eval(float z_from, float z_to) const {
        // Transmission is computed from outside, so that an exchange of both directions changes no
        // bit.
        const bool through = z_from * z_to < 0;
        const float z = through ? 1 : z_to;
        const float share = through ? passing(z) / (eta * eta) : 1 - passing(z);
        return share * lost(z_from) * lost(z_to) / (kPi * mean_lost(through ? -z : z));
    }

    /// Returns the density of directions, given that this lobe was selected.
    float pdf(float z_from, float z_to) const {
        const float through = passing(z_from);
        return (z_from * z_to < 0 ? through : 1 - through) * std::abs(z_to) / kPi;
    }

private:
    float far_over_near(float z) const { return z > 0 ? eta : 1 / eta; }
};

}  // namespace sunfleck::engine
