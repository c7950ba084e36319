// The wide lobes that give back what rough facets lose (bsdf/facet_losses.h): of metal, of glass.
//
// In:  facets, cosines with the normal. Out: f, the chance and the density by which it is sampled.
// Source: Kulla and Conty 2017, as there; of glass the split below is our own.
//
// Glass, with n the index and A the mean loss on either side: f(a -> b) = n_b^2 k L(a) L(b) / pi is
// reciprocal for one k per pair of sides. All is given back if t = k n^2 A (of the other side)
// passes through and 1 - t stays. We take the largest k of both sides with which neither passes
// more than a smooth boundary does of evenly spread light.
#pragma once

#include "bsdf/facet_losses.h"
#include "bsdf/fresnel.h"

namespace sunfleck::engine {

struct MetalCompensation {
    const FacetLosses& losses;
    const Ggx& facets;

    float lost(float z) const { return losses.of_mirror(facets, std::abs(z)); }

    /// The share that further facets reflect of what a first one has lost, colours deepened.
    SampledSpectrum reflectance(const SampledSpectrum& eta, const SampledSpectrum& k) const {
        // Gauss's rule of four points in the squared cosine, which is uniform.
        const SampledSpectrum mean = 0.1739274F * (conductor_reflectance(0.2634992F, eta, k) +
                                                   conductor_reflectance(0.9646596F, eta, k)) +
                                     0.3260726F * (conductor_reflectance(0.5744645F, eta, k) +
                                                   conductor_reflectance(0.8185295F, eta, k));
        const float lost_again = losses.mean_of_mirror(facets);
        return mean * mean * (1 - lost_again) / (SampledSpectrum(1) - mean * lost_again);
    }

    /// f where reflectance() is one.
    float eval(float z_from, float z_to) const {
        return lost(z_from) * lost(z_to) / (kPi * losses.mean_of_mirror(facets));
    }
};

struct GlassCompensation {
    const FacetLosses& losses;
    const Ggx& facets;
    float eta;  // inside (side -z) over outside

    /// @param z  the cosine of a direction: its side counts.
    float lost(float z) const { return losses.of_glass(facets, std::abs(z), far_over_near(z)); }
    float mean_lost(float z) const { return losses.mean_of_glass(facets, far_over_near(z)); }

    /// Of what is lost on the side of z, the share that goes to the other.
    float passing(float z) const {
        const float here = mean_lost(z);
        const float there = mean_lost(-z);
        const float smooth = 1 - mean_dielectric_reflectance(far_over_near(z));
        return smooth * there / std::max(here, there);
    }

    /// f; where it goes through the surface, over the squared index of the side that it goes to.
    float eval(float z_from, float z_to) const {
        // Seen from outside where it goes through: no bit may change when both are swapped.
        const bool through = z_from * z_to < 0;
        const float z = through ? 1 : z_to;
        const float share = through ? passing(z) / (eta * eta) : 1 - passing(z);
        return share * lost(z_from) * lost(z_to) / (kPi * mean_lost(through ? -z : z));
    }

    /// Density of directions after `lost` of the chance has gone to this lobe.
    float pdf(float z_from, float z_to) const {
        const float through = passing(z_from);
        return (z_from * z_to < 0 ? through : 1 - through) * std::abs(z_to) / kPi;
    }

private:
    float far_over_near(float z) const { return z > 0 ? eta : 1 / eta; }
};

}  // namespace sunfleck::engine
