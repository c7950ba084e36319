// Quantities that vary over surfaces: numbers and spectra, as trees of the kinds of kinds.h.
//
// Values: cheap to copy, immutable once made, usable by any number of threads. No filtering: a
// texture is asked at a point (docs/scenes.md).
#pragma once

#include "math/spectral_curve.h"
#include "texture/mapping.h"

#include <memory>

namespace sunfleck {

struct FloatKind;
struct SpectrumKind;

class FloatTexture {
public:
    FloatTexture(float constant = 0) : constant_(constant) {}  // NOLINT: a number is a texture
    explicit FloatTexture(FloatKind kind);

    bool is_constant() const { return kind_ == nullptr; }
    /// Of a constant one.
    float constant() const { return constant_; }
    float at(const TexturePoint& point) const { return kind_ ? varied(point) : constant_; }

private:
    float varied(const TexturePoint& point) const;

    float constant_;
    std::shared_ptr<const FloatKind> kind_;
};

class SpectrumTexture {
public:
    SpectrumTexture() = default;
    SpectrumTexture(SpectralCurve curve) : curve_(std::move(curve)) {}  // NOLINT: likewise
    explicit SpectrumTexture(SpectrumKind kind);

    bool is_constant() const { return kind_ == nullptr; }
    /// Of a constant one.
    const SpectralCurve& curve() const { return curve_; }
    Spectrum at(const TexturePoint& point, const Wavelengths& wavelengths) const {
        return kind_ ? varied(point, wavelengths) : curve_.at(wavelengths);
    }

private:
    Spectrum varied(const TexturePoint& point, const Wavelengths& wavelengths) const;

    SpectralCurve curve_;
    std::shared_ptr<const SpectrumKind> kind_;
};

}  // namespace sunfleck
