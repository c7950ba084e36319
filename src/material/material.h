// What a surface is made of, as a scene says it; bsdf_of() makes the Bsdf of one pass, and of one
// point where textures vary, from it.
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

/// Below this in both alphas facets are not seen: the surface is perfectly smooth (pbrt-v4).
inline constexpr float kSmoothAlpha = 1e-3F;

/// The GGX alpha of a scene's "roughness" where it asks for remapping (pbrt-v4's remaproughness).
/// @param roughness  not negative.
inline float alpha_from_roughness(float roughness) {
    return std::sqrt(roughness);
}

struct DiffuseMaterial {
    static constexpr std::string_view name = "diffuse";
    SpectrumTexture reflectance = Spectrum::constant(0.5F);
};

/// Along the tangent and across: GGX alphas, or what alpha_from_roughness() makes them from.
struct Roughness {
    FloatTexture u;
    FloatTexture v;
    bool remap = false;
    bool gives_back = false;  // what facets lose (bsdf/facet_losses.h); not beside a coat

    /// The alphas; below kSmoothAlpha in both the surface is perfectly smooth.
    Vec2 alphas(const TexturePoint& point) const;
    bool is_constant() const { return u.is_constant() && v.is_constant(); }
    /// Null where losses stay lost.
    const FacetLosses* losses() const { return gives_back ? &FacetLosses::table() : nullptr; }
};

struct DielectricMaterial {
    static constexpr std::string_view name = "dielectric";
    Spectrum eta = Spectrum::constant(1.5F);  // inside over outside
    Roughness roughness;
};

struct ThinDielectricMaterial {
    static constexpr std::string_view name = "thindielectric";
    Spectrum eta = Spectrum::constant(1.5F);
};

struct ConductorMaterial {
    static constexpr std::string_view name = "conductor";
    SpectrumTexture eta;
    SpectrumTexture k;
    std::optional<SpectrumTexture> reflectance;  // instead: eta 1, k = 2 sqrt(r) / sqrt(1 - r)
    Roughness roughness;
};

/// Diffuse under a clear coat.
struct CoatedDiffuseMaterial {
    static constexpr std::string_view name = "coateddiffuse";
    SpectrumTexture reflectance = Spectrum::constant(0.5F);  // of the base, without the coat
    std::shared_ptr<const Coat> coat;                        // not null
    bool whole = false;  // the reflectance is that of the light which enters the coat, as it leaves
};

/// Metal under a clear coat.
struct CoatedConductorMaterial {
    static constexpr std::string_view name = "coatedconductor";
    ConductorMaterial metal;
    std::shared_ptr<const Coat> coat;  // not null
};

/// Scattered evenly, back and through. Together at most one: a larger sum is scaled down.
struct DiffuseTransmissionMaterial {
    static constexpr std::string_view name = "diffusetransmission";
    SpectrumTexture reflectance = Spectrum::constant(0.25F);
    SpectrumTexture transmittance = Spectrum::constant(0.25F);
};

/// Two materials, one of which a ray meets.
struct MixMaterial {
    static constexpr std::string_view name = "mix";
    std::array<std::uint32_t, 2> parts{};  // numbers of materials; never interfaces
    FloatTexture amount = 0.5F;            // the chance of the second

    /// Which part is met, by a hash of the place: the same for all that meet it there.
    std::uint32_t chosen(const TexturePoint& point) const;
};

/// A surface that is not there: light passes straight, and it is no bounce.
struct InterfaceMaterial {
    static constexpr std::string_view name = "interface";
};

/// name: as `sunfleck info` says it.
template <class M>
concept MaterialModel = std::copyable<M> && requires {
    { M::name } -> std::convertible_to<std::string_view>;
};

template <MaterialModel... Models>
using MaterialVariant = std::variant<Models...>;

using Material = MaterialVariant<DiffuseMaterial, DielectricMaterial, ThinDielectricMaterial,
                                 ConductorMaterial, CoatedDiffuseMaterial, CoatedConductorMaterial,
                                 DiffuseTransmissionMaterial, MixMaterial, InterfaceMaterial>;

/// As `sunfleck info` says it.
inline std::string_view name_of(const Material& material) {
    return std::visit([](const auto& m) { return m.name; }, material);
}

/// Does the Bsdf depend on the point?
bool is_textured(const Material& material);

/// Can the Bsdf gather light (other than Scattering::specular) at some point? Of a mix its parts
/// know.
bool may_gather(const Material& material);

/// The material at one pass's wavelengths and at a point, which counts where it is textured;
/// nothing for an interface, and for a mix, whose parts have their own.
///
/// Limits, as in pbrt-v4: reflectances are held in [0,1] (of a conductor in [0, 0.9999], where k is
/// finite); an alpha below 1e-4 beside a larger one counts as 1e-4; a curve that gives no index
/// (eta <= 0) at a wavelength gives 1 there. A rough dielectric with an index within
/// RoughDielectric::kLeastContrast of 1 is smooth.
std::optional<Bsdf> bsdf_of(const Material& material, const Wavelengths& wavelengths,
                            const TexturePoint& point = {});

}  // namespace sunfleck::engine
