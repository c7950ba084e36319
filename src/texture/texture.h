// FloatTexture and SpectrumTexture: quantities that vary over surfaces, as trees of texture kinds.
//
// Textures are values: cheap to copy, immutable, thread-safe. They are not filtered, but evaluated
// at a point (docs/reference/scenes.md).
// To add a kind: its struct in kinds.h, its name in a variant below, its value in texture.cpp, a
// row in import/pbrt/textures.cpp.
#pragma once

#include "math/spectrum.h"
#include "texture/image_kind.h"
#include "texture/kinds.h"
#include "texture/mapping.h"

#include <memory>
#include <variant>

namespace sunfleck::engine {

struct FloatKind;
struct SpectrumKind;

class FloatTexture {
public:
    using Number = FloatTexture;

    FloatTexture(float constant = 0) : constant_(constant) {}  // NOLINT: a number is a texture
    explicit FloatTexture(FloatKind kind);

    bool is_constant() const { return kind_ == nullptr; }
    /// Returns the value of a constant texture.
    float constant() const { return constant_; }
    float at(const TexturePoint& point) const { return kind_ ? varied(point) : constant_; }
    /// Returns what the texture is made of; null if it is constant. Copies have the same pointer.
    const FloatKind* kind() const { return kind_.get(); }

private:
    float varied(const TexturePoint& point) const;

    float constant_;
    std::shared_ptr<const FloatKind> kind_;
};

class SpectrumTexture {
public:
    using Number = FloatTexture;

    SpectrumTexture() = default;
    SpectrumTexture(Spectrum curve)
        : curve_(std::move(curve)) {}  // NOLINT: a spectrum is a texture
    explicit SpectrumTexture(SpectrumKind kind);

    bool is_constant() const { return kind_ == nullptr; }
    /// Returns the spectrum of a constant texture.
    const Spectrum& curve() const { return curve_; }
    SampledSpectrum at(const TexturePoint& point, const Wavelengths& wavelengths) const {
        return kind_ ? varied(point, wavelengths) : curve_.at(wavelengths);
    }
    /// Returns what the texture is made of; null if it is constant. Copies have the same pointer.
    const SpectrumKind* kind() const { return kind_.get(); }

private:
    SampledSpectrum varied(const TexturePoint& point, const Wavelengths& wavelengths) const;

    Spectrum curve_;
    std::shared_ptr<const SpectrumKind> kind_;
};

struct FloatKind {
    std::variant<ScaledKind<FloatTexture>, MixKind<FloatTexture>, DirectionMixKind<FloatTexture>,
                 CheckerboardKind<FloatTexture>, DotsKind<FloatTexture>, BilerpKind<FloatTexture>,
                 FloatImageKind, VertexNumberKind, FbmKind, WrinkledKind, WindyKind>
        kind;
};

struct SpectrumKind {
    std::variant<ScaledKind<SpectrumTexture>, MixKind<SpectrumTexture>,
                 DirectionMixKind<SpectrumTexture>, CheckerboardKind<SpectrumTexture>,
                 DotsKind<SpectrumTexture>, BilerpKind<SpectrumTexture>, SpectrumImageKind,
                 VertexColourKind, MarbleKind>
        kind;
};

}  // namespace sunfleck::engine
