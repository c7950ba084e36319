// Evaluation of materials at the wavelengths of a pass and at a point.
#include "material/material.h"

#include "core/hash.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace sunfleck::engine {

namespace {

SampledSpectrum clamped(const SampledSpectrum& s, float low, float high) {
    SampledSpectrum inside;
    for (std::size_t i = 0; i < kWavelengths; ++i) inside[i] = std::clamp(s[i], low, high);
    return inside;
}

bool is_smooth(const Vec2& alphas) {
    return std::max(alphas.x, alphas.y) < kSmoothAlpha;
}

Ggx facets_of(const Vec2& alphas) {
    return {std::max(alphas.x, 1e-4F), std::max(alphas.y, 1e-4F)};
}

/// Returns indices of refraction, 1 where an index is not positive.
SampledSpectrum index_of(SampledSpectrum eta) {
    for (float& v : eta.values)
        if (!(v > 0)) v = 1;
    return eta;
}

bool bends(const SampledSpectrum& eta) {
    return std::all_of(eta.values.begin(), eta.values.end(),
                       [](float v) { return std::abs(v - 1) > RoughDielectric::kLeastContrast; });
}

/// Complex index of a metal.
struct MetalIndex {
    SampledSpectrum eta;
    SampledSpectrum k;
};

/// Returns the albedo below a coat with which a fraction `whole` of the entering light leaves:
/// whole = albedo leaving / (1 - albedo returning). It exceeds one where it compensates the losses
/// of a rough coat; still no more light is scattered than enters.
SampledSpectrum base_below(const Coat& coat, const SampledSpectrum& whole) {
    const float leaving = coat.mean_entering() / (coat.eta() * coat.eta());
    const SampledSpectrum needed = whole / leaving;
    return needed / (SampledSpectrum(1) + needed * coat.returning());
}

/// One overload per material.
struct BsdfOf {
    const Wavelengths& wavelengths;
    const TexturePoint& point;

    std::optional<Bsdf> operator()(const DiffuseMaterial& m) const {
        return Lambert{clamped(m.reflectance.at(point, wavelengths), 0, 1)};
    }

    std::optional<Bsdf> operator()(const DielectricMaterial& m) const {
        const SampledSpectrum eta = index_of(m.eta.at(wavelengths));
        const Vec2 alphas = m.roughness.alphas(point);
        if (is_smooth(alphas) || !bends(eta)) return SmoothDielectric(eta);
        return RoughDielectric(eta, facets_of(alphas), m.roughness.losses());
    }

    std::optional<Bsdf> operator()(const ThinDielectricMaterial& m) const {
        return ThinDielectric{index_of(m.eta.at(wavelengths)),
                              clamped(m.colour.at(point, wavelengths), 0, 1)};
    }

    std::optional<Bsdf> operator()(const ConductorMaterial& m) const {
        const auto [eta, k] = metal_index(m);
        const Vec2 alphas = m.roughness.alphas(point);
        if (is_smooth(alphas)) return SmoothConductor{eta, k};
        return RoughConductor{eta, k, facets_of(alphas), m.roughness.losses()};
    }

    std::optional<Bsdf> operator()(const IridescentConductorMaterial& m) const {
        const Vec2 alphas = m.metal.roughness.alphas(point);
        ThinFilm film{m.film_eta, {}};
        const float thickness = std::max(0.0F, m.thickness.at(point));
        for (std::size_t i = 0; i < kWavelengths; ++i)
            film.waves[i] = thickness / wavelengths.nm.at(i);
        return IridescentConductor{
            metal_index(m.metal).k, film,
            Ggx{std::max(alphas.x, kSmoothAlpha), std::max(alphas.y, kSmoothAlpha)},
            m.metal.roughness.losses()};
    }

    std::optional<Bsdf> operator()(const CoatedDiffuseMaterial& m) const {
        const SampledSpectrum given = clamped(m.reflectance.at(point, wavelengths), 0, 1);
        return CoatedDiffuse{m.whole ? base_below(*m.coat, given) : given, m.coat.get()};
    }

    std::optional<Bsdf> operator()(const CoatedConductorMaterial& m) const {
        const auto [eta, k] = metal_index(m.metal);
        const Vec2 alphas = m.metal.roughness.alphas(point);
        std::optional<Ggx> facets;
        if (!is_smooth(alphas)) facets = facets_of(alphas);
        return CoatedConductor(eta, k, facets, m.coat.get());
    }

    std::optional<Bsdf> operator()(const DiffuseTransmissionMaterial& m) const {
        SampledSpectrum back = clamped(m.reflectance.at(point, wavelengths), 0, 1);
        SampledSpectrum through = clamped(m.transmittance.at(point, wavelengths), 0, 1);
        for (std::size_t i = 0; i < kWavelengths; ++i) {
            const float over = std::max(1.0F, back[i] + through[i]);
            back[i] /= over;
            through[i] /= over;
        }
        return DiffuseTransmission{back, through};
    }

    std::optional<Bsdf> operator()(const MixMaterial&) const { return {}; }
    std::optional<Bsdf> operator()(const InterfaceMaterial&) const { return {}; }

    MetalIndex metal_index(const ConductorMaterial& m) const {
        if (!m.reflectance)
            return {index_of(m.eta.at(point, wavelengths)),
                    clamped(m.k.at(point, wavelengths), 0, std::numeric_limits<float>::max())};
        const SampledSpectrum r = clamped(m.reflectance->at(point, wavelengths), 0, 0.9999F);
        return {SampledSpectrum(1), 2 * sqrt(r) / sqrt(SampledSpectrum(1) - r)};
    }
};

struct IsTextured {
    bool operator()(const DiffuseMaterial& m) const { return !m.reflectance.is_constant(); }
    bool operator()(const DielectricMaterial& m) const { return !m.roughness.is_constant(); }
    bool operator()(const ConductorMaterial& m) const {
        const bool reflects_evenly = !m.reflectance || m.reflectance->is_constant();
        return !(reflects_evenly && m.eta.is_constant() && m.k.is_constant() &&
                 m.roughness.is_constant());
    }
    bool operator()(const IridescentConductorMaterial& m) const {
        return !m.thickness.is_constant() || (*this)(m.metal);
    }
    bool operator()(const CoatedDiffuseMaterial& m) const { return !m.reflectance.is_constant(); }
    bool operator()(const CoatedConductorMaterial& m) const { return (*this)(m.metal); }
    bool operator()(const DiffuseTransmissionMaterial& m) const {
        return !(m.reflectance.is_constant() && m.transmittance.is_constant());
    }
    bool operator()(const MixMaterial&) const { return true; }
    bool operator()(const ThinDielectricMaterial& m) const { return !m.colour.is_constant(); }
    bool operator()(const InterfaceMaterial&) const { return false; }
};

/// One overload per material.
struct MayGather {
    bool operator()(const DiffuseMaterial&) const { return true; }
    bool operator()(const DielectricMaterial& m) const { return is_rough_somewhere(m.roughness); }
    bool operator()(const ConductorMaterial& m) const { return is_rough_somewhere(m.roughness); }
    bool operator()(const IridescentConductorMaterial&) const { return true; }
    bool operator()(const CoatedDiffuseMaterial&) const { return true; }
    bool operator()(const CoatedConductorMaterial&) const { return true; }
    bool operator()(const DiffuseTransmissionMaterial&) const { return true; }
    bool operator()(const MixMaterial&) const { return false; }
    bool operator()(const ThinDielectricMaterial&) const { return false; }
    bool operator()(const InterfaceMaterial&) const { return false; }

    static bool is_rough_somewhere(const Roughness& roughness) {
        return !roughness.is_constant() || !is_smooth(roughness.alphas({}));
    }
};

}  // namespace

Vec2 Roughness::alphas(const TexturePoint& point) const {
    const Vec2 given(std::max(0.0F, u.at(point)), std::max(0.0F, v.at(point)));
    return remap ? Vec2(alpha_from_roughness(given.x), alpha_from_roughness(given.y)) : given;
}

std::uint32_t MixMaterial::chosen(const TexturePoint& point) const {
    const float second = amount.at(point);
    std::uint64_t hash = hash_joined(components[0], components[1]);
    for (int i = 0; i < 3; ++i)
        hash = hash_joined(hash, std::bit_cast<std::uint32_t>(point.position[i]));
    return components.at(hash_to_unit(hash) < second ? 1 : 0);
}

bool is_textured(const Material& material) {
    return std::visit(IsTextured{}, material);
}

bool may_gather(const Material& material) {
    return std::visit(MayGather{}, material);
}

std::optional<Bsdf> bsdf_of(const Material& material, const Wavelengths& wavelengths,
                            const TexturePoint& point) {
    return std::visit(BsdfOf{wavelengths, point}, material);
}

}  // namespace sunfleck::engine
