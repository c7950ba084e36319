// BSDF: variant of all BSDF models, and of phase functions, with functions that dispatch to them.
// To add one: docs/develop/adding.md.
#pragma once

#include "bsdf/coated_conductor.h"
#include "bsdf/coated_diffuse.h"
#include "bsdf/diffuse_transmission.h"
#include "bsdf/henyey_greenstein.h"
#include "bsdf/iridescent_conductor.h"
#include "bsdf/lambert.h"
#include "bsdf/model.h"
#include "bsdf/rough_conductor.h"
#include "bsdf/rough_dielectric.h"
#include "bsdf/smooth_conductor.h"
#include "bsdf/smooth_dielectric.h"
#include "bsdf/thin_dielectric.h"

#include <variant>

namespace sunfleck::engine {

template <BsdfModel... Models>
using BsdfVariant = std::variant<Models...>;

/// BSDF at one point of a surface, or phase function at one of a medium: a value, which visible
/// points copy.
using Bsdf =
    BsdfVariant<Lambert, SmoothDielectric, RoughDielectric, ThinDielectric, SmoothConductor,
                RoughConductor, IridescentConductor, CoatReflection, CoatedBase, CoatedDiffuse,
                CoatedConductor, DiffuseTransmission, HenyeyGreenstein>;

/// Returns f per steradian, without the cosine; zero for delta lobes (bsdf/model.h).
inline SampledSpectrum eval(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi, Transport transport) {
    return std::visit([&](const auto& b) { return b.eval(wo, wi, transport); }, bsdf);
}

/// Returns the density per steradian with which sample() chooses wi, given wo; zero for delta
/// lobes. For dispersive glossy BSDFs, see RoughDielectric::pdf.
inline float pdf(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi, Transport transport) {
    return std::visit([&](const auto& b) { return b.pdf(wo, wi, transport); }, bsdf);
}

/// Samples the direction in which a path continues; nothing when the path is absorbed.
inline std::optional<BsdfSample> sample(const Bsdf& bsdf, const Vec3& wo,
                                        const BsdfSampleInput& draw) {
    // Most surfaces are Lambertian: the compiler can inline this case.
    if (const auto* lambert = std::get_if<Lambert>(&bsdf)) return lambert->sample(wo, draw);
    return std::visit([&](const auto& b) { return b.sample(wo, draw); }, bsdf);
}

inline Scattering scattering(const Bsdf& bsdf) {
    return std::visit([](const auto& b) { return b.scattering(); }, bsdf);
}

/// Returns whether it is the phase function of a medium.
inline bool is_of_medium(const Bsdf& bsdf) {
    return std::visit([]<class B>(const B&) { return VolumeModel<B>; }, bsdf);
}

/// Returns the cosine that belongs to f: one in a medium, which has no normal.
inline float cosine_of(const Bsdf& bsdf, const Vec3& wi) {
    return is_of_medium(bsdf) ? 1 : std::abs(wi.z);
}

/// Returns whether eval() can be nonzero for directions of these sides.
/// @param z_from, z_to  cosines with the normal, of which the signs alone count.
inline bool gathers(const Bsdf& bsdf, float z_from, float z_to) {
    return std::visit([&](const auto& b) { return b.gathers(z_from, z_to); }, bsdf);
}

/// Returns the albedo of the diffuse lobe, seen from wo; zero where there is none (bsdf/model.h).
inline SampledSpectrum diffuse_albedo(const Bsdf& bsdf, const Vec3& wo) {
    return std::visit([&](const auto& b) { return b.diffuse_albedo(wo); }, bsdf);
}

/// Returns whether the directions that sample() returns depend on wavelength.
inline bool is_dispersive(const Bsdf& bsdf) {
    return std::visit(
        []<class B>(const B& b) {
            if constexpr (DispersiveModel<B>) return b.is_dispersive();
            return false;
        },
        bsdf);
}

/// Returns the probability with which sample() chooses reflection from two delta lobes, which it
/// does where draw.u.x is below it; zero for a BSDF without two delta lobes.
inline float reflection_probability(const Bsdf& bsdf, const Vec3& wo, const HeroWavelength& hero) {
    return std::visit([&](const auto& b) { return b.reflection_probability(wo, hero); }, bsdf);
}

/// Returns the BSDF with the refractive index of one wavelength at all: it is not dispersive.
/// @param wavelength  index of the wavelength, below kWavelengths.
inline Bsdf at_wavelength(const Bsdf& bsdf, std::size_t wavelength) {
    return std::visit(
        [&]<class B>(const B& b) -> Bsdf {
            if constexpr (DispersiveModel<B>) return b.at_wavelength(wavelength);
            return b;
        },
        bsdf);
}

}  // namespace sunfleck::engine
