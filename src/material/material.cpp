// Materials at a pass's wavelengths.
#include "material/material.h"

#include <algorithm>
#include <limits>

namespace sunfleck {

namespace {

Spectrum clamped(const Spectrum& s, float low, float high) {
    Spectrum inside;
    for (std::size_t i = 0; i < kLanes; ++i) inside[i] = std::clamp(s[i], low, high);
    return inside;
}

bool is_smooth(const Roughness& roughness) {
    return std::max(roughness.alpha_u, roughness.alpha_v) < kSmoothAlpha;
}

Ggx facets_of(const Roughness& roughness) {
    return {std::max(roughness.alpha_u, 1e-4F), std::max(roughness.alpha_v, 1e-4F)};
}

/// Indices of refraction: 1 where the curve has none.
Spectrum index_of(const SpectralCurve& curve, const Wavelengths& wavelengths) {
    Spectrum eta = curve.at(wavelengths);
    for (float& v : eta.lane)
        if (!(v > 0)) v = 1;
    return eta;
}

bool bends(const Spectrum& eta) {
    return std::all_of(eta.lane.begin(), eta.lane.end(),
                       [](float v) { return std::abs(v - 1) > RoughDielectric::kLeastContrast; });
}

/// Complex index of a metal.
struct MetalIndex {
    Spectrum eta;
    Spectrum k;
};

MetalIndex metal_index(const ConductorMaterial& material, const Wavelengths& wavelengths) {
    if (!material.reflectance)
        return {index_of(material.eta, wavelengths),
                clamped(material.k.at(wavelengths), 0, std::numeric_limits<float>::max())};
    const Spectrum r = clamped(material.reflectance->at(wavelengths), 0, 0.9999F);
    return {Spectrum(1), 2 * sqrt(r) / sqrt(Spectrum(1) - r)};
}

/// One overload a material.
struct BsdfOf {
    const Wavelengths& wavelengths;

    std::optional<Bsdf> operator()(const DiffuseMaterial& m) const {
        return Lambert{clamped(m.reflectance.at(wavelengths), 0, 1)};
    }

    std::optional<Bsdf> operator()(const DielectricMaterial& m) const {
        const Spectrum eta = index_of(m.eta, wavelengths);
        if (is_smooth(m.roughness) || !bends(eta)) return SmoothDielectric(eta);
        return RoughDielectric(eta, facets_of(m.roughness));
    }

    std::optional<Bsdf> operator()(const ThinDielectricMaterial& m) const {
        return ThinDielectric{index_of(m.eta, wavelengths)};
    }

    std::optional<Bsdf> operator()(const ConductorMaterial& m) const {
        const auto [eta, k] = metal_index(m, wavelengths);
        if (is_smooth(m.roughness)) return SmoothConductor{eta, k};
        return RoughConductor{eta, k, facets_of(m.roughness)};
    }

    std::optional<Bsdf> operator()(const InterfaceMaterial&) const { return {}; }
};

}  // namespace

std::optional<Bsdf> bsdf_of(const Material& material, const Wavelengths& wavelengths) {
    return std::visit(BsdfOf{wavelengths}, material);
}

}  // namespace sunfleck
