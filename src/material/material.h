// Material: the parameters of a surface as a scene gives them; bsdf_of() evaluates them at a point
// for one pass.
//
// To add one: docs/develop/adding.md.
#pragma once

#include "bsdf/bsdf.h"
#include "texture/texture.h"

#include <array>
#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

namespace sunfleck::engine {

/// If both alphas are smaller, the surface is treated as perfectly smooth (pbrt-v4).
inline constexpr float kSmoothAlpha = 1e-3F;

/// Returns the GGX alpha of a "roughness" with remapping (pbrt-v4's remaproughness).
/// @param roughness  not negative.
inline float alpha_from_roughness(float roughness) {
    return std::sqrt(roughness);
}

struct DiffuseMaterial {
    static constexpr std::string_view name = "diffuse";
    SpectrumTexture reflectance = Spectrum::constant(0.5F);
};

/// GGX alphas along and across the tangent, or the input of alpha_from_roughness().
struct Roughness {
    FloatTexture u;
    FloatTexture v;
    bool remap = false;
    bool gives_back = false;  // energy compensation (bsdf/facet_losses.h); not under a coat

    /// Returns the alphas; below kSmoothAlpha in both, the surface is perfectly smooth.
    Vec2 alphas(const TexturePoint& point) const;
    bool is_constant() const { return u.is_constant() && v.is_constant(); }
    /// Returns the table for energy compensation, or null without it.
    const FacetLosses* losses() const { return gives_back ? &FacetLosses::table() : nullptr; }
};

struct DielectricMaterial {
    static constexpr std::string_view name = "dielectric";
    Spectrum eta = Spectrum::constant(1.5F);  // index inside over outside
    Roughness roughness;
};

struct ThinDielectricMaterial {
    static constexpr std::string_view name = "thindielectric";
    Spectrum eta = Spectrum::constant(1.5F);
    SpectrumTexture colour = Spectrum::constant(1);  // of what passes
};

struct ConductorMaterial {
    static constexpr std::string_view name = "conductor";
    SpectrumTexture eta;
    SpectrumTexture k;
    std::optional<SpectrumTexture>
        reflectance;  // in place of eta and k: eta 1, k = 2 sqrt(r) / sqrt(1 - r)
    Roughness roughness;
};

/// Metal under a thin film with the colours of interference. Its facets have an alpha of
/// kSmoothAlpha at least.
struct IridescentConductorMaterial {
    static constexpr std::string_view name = "iridescentconductor";
    ConductorMaterial metal;  // with a reflectance
    float film_eta = 1.33F;   // at least 1
    FloatTexture thickness;   // of the film, nanometres
};

/// A diffuse base under a clear coat.
struct CoatedDiffuseMaterial {
    static constexpr std::string_view name = "coateddiffuse";
    SpectrumTexture reflectance = Spectrum::constant(0.5F);  // of the base, without the coat
    std::shared_ptr<const Coat> coat;                        // not null
    bool whole = false;  // the reflectance is that seen from below the coat's surface
};

/// Metal under a clear coat.
struct CoatedConductorMaterial {
    static constexpr std::string_view name = "coatedconductor";
    ConductorMaterial metal;
    std::shared_ptr<const Coat> coat;  // not null
};

/// Diffuse reflection and transmission. A sum above one is scaled down.
struct DiffuseTransmissionMaterial {
    static constexpr std::string_view name = "diffusetransmission";
    SpectrumTexture reflectance = Spectrum::constant(0.25F);
    SpectrumTexture transmittance = Spectrum::constant(0.25F);
};

/// A mix of two materials, one of which is selected at each point.
struct MixMaterial {
    static constexpr std::string_view name = "mix";
    std::array<std::uint32_t, 2> components{};  // indices of materials; never interfaces
    FloatTexture amount = 0.5F;                 // probability of the second

    /// Selects a material by a hash of the position: the same for all paths that hit that point.
    std::uint32_t chosen(const TexturePoint& point) const;
};

/// A null interface: paths pass it without a scattering event.
struct InterfaceMaterial {
    static constexpr std::string_view name = "interface";
};

/// name: as `sunfleck info` prints it.
template <class M>
concept MaterialModel = std::copyable<M> && requires {
    { M::name } -> std::convertible_to<std::string_view>;
};

template <MaterialModel... Models>
using MaterialVariant = std::variant<Models...>;

using Material =
    MaterialVariant<DiffuseMaterial, DielectricMaterial, ThinDielectricMaterial, ConductorMaterial,
                    IridescentConductorMaterial, CoatedDiffuseMaterial, CoatedConductorMaterial,
                    DiffuseTransmissionMaterial, MixMaterial, InterfaceMaterial>;

/// As `sunfleck info` says it.
inline std::string_view name_of(const Material& material) {
    return std::visit([](const auto& m) { return m.name; }, material);
}

/// Returns whether the Bsdf depends on the point.
bool is_textured(const Material& material);

/// Returns whether the Bsdf can gather light (is not Scattering::specular) at some point. A mix
/// returns false; ask its components.
bool may_gather(const Material& material);

/// Returns the Bsdf at the wavelengths of a pass and at a point; nothing for an interface, and for
/// a mix, whose components have Bsdfs of their own.
///
/// Limits are those of pbrt-v4. Reflectances are clamped to [0,1] (of a conductor to [0, 0.9999],
/// where k is finite). An alpha below 1e-4 beside a larger one becomes 1e-4. An index that is not
/// positive at a wavelength becomes 1 there. A rough dielectric with an index within
/// RoughDielectric::kLeastContrast of 1 becomes smooth.
std::optional<Bsdf> bsdf_of(const Material& material, const Wavelengths& wavelengths,
                            const TexturePoint& point = {});

}  // namespace sunfleck::engine
