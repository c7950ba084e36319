// Every BSDF there is, as one value. To add one: docs/develop/adding.md.
#pragma once

#include "bsdf/coated_conductor.h"
#include "bsdf/coated_diffuse.h"
#include "bsdf/diffuse_transmission.h"
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

/// A BSDF at one point of a surface: a value, copied into the visible point that needs it.
using Bsdf = BsdfVariant<Lambert, SmoothDielectric, RoughDielectric, ThinDielectric,
                         SmoothConductor, RoughConductor, CoatReflection, CoatedBase, CoatedDiffuse,
                         CoatedConductor, DiffuseTransmission>;

/// f per steradian, without the cosine; zero for delta lobes (bsdf/model.h).
inline SampledSpectrum eval(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi, Transport transport) {
    return std::visit([&](const auto& b) { return b.eval(wo, wi, transport); }, bsdf);
}

/// Density per steradian with which sample() chooses wi, given wo; zero for delta lobes.
/// Dispersive and glossy: see RoughDielectric::pdf.
inline float pdf(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi, Transport transport) {
    return std::visit([&](const auto& b) { return b.pdf(wo, wi, transport); }, bsdf);
}

/// A direction to go on in; nothing when the light is absorbed.
inline std::optional<BsdfSample> sample(const Bsdf& bsdf, const Vec3& wo,
                                        const BsdfSampleInput& draw) {
    // Most surfaces are: worth the compiler's seeing through.
    if (const auto* lambert = std::get_if<Lambert>(&bsdf)) return lambert->sample(wo, draw);
    return std::visit([&](const auto& b) { return b.sample(wo, draw); }, bsdf);
}

inline Scattering scattering(const Bsdf& bsdf) {
    return std::visit([](const auto& b) { return b.scattering(); }, bsdf);
}

/// Whether eval() can be other than zero: can light of the side of z_to be gathered on that of
/// z_from? @param z_from, z_to  cosines with the normal, of which the signs alone count.
inline bool gathers(const Bsdf& bsdf, float z_from, float z_to) {
    return std::visit([&](const auto& b) { return b.gathers(z_from, z_to); }, bsdf);
}

/// The diffuse albedo of the wide lobe, seen from wo; zero where there is none (bsdf/model.h).
inline SampledSpectrum diffuse_albedo(const Bsdf& bsdf, const Vec3& wo) {
    return std::visit([&](const auto& b) { return b.diffuse_albedo(wo); }, bsdf);
}

/// Whether wavelengths part in direction here.
inline bool is_dispersive(const Bsdf& bsdf) {
    return std::visit(
        []<class B>(const B& b) {
            if constexpr (DispersiveModel<B>) return b.is_dispersive();
            return false;
        },
        bsdf);
}

/// The probability with which sample() takes the first of two delta lobes: with draw.u.x below it.
/// Zero for a surface that has no two.
inline float reflection_probability(const Bsdf& bsdf, const Vec3& wo, const HeroWavelength& hero) {
    return std::visit([&](const auto& b) { return b.reflection_probability(wo, hero); }, bsdf);
}

/// The same BSDF with that wavelength's index in every wavelength: no longer dispersive. @param
/// wavelength  below kWavelengths.
inline Bsdf at_wavelength(const Bsdf& bsdf, std::size_t wavelength) {
    return std::visit(
        [&]<class B>(const B& b) -> Bsdf {
            if constexpr (DispersiveModel<B>) return b.at_wavelength(wavelength);
            return b;
        },
        bsdf);
}

}  // namespace sunfleck::engine
