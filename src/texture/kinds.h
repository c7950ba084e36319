// Every kind of texture there is, with the meaning that pbrt-v4 gives it. To add one: its struct
// here, its name in a variant below, its value in texture.cpp, a row in import/pbrt/textures.cpp.
#pragma once

#include "image/lookup.h"
#include "texture/noise.h"
#include "texture/texture.h"

#include <memory>
#include <variant>

namespace sunfleck {

/// What a spectrum stands for: it says what the colour of a texel means.
enum class ColourUse {
    albedo,     // brought into [0,1]
    unbounded,  // any non-negative quantity
    illuminant  // likewise, under D65
};

/// texture * factor. @tparam T  FloatTexture or SpectrumTexture, here and below.
template <class T>
struct ScaledKind {
    T texture;
    FloatTexture factor;
};

/// first * (1 - amount) + second * amount.
template <class T>
struct MixKind {
    T first;
    T second;
    FloatTexture amount;
};

/// `first` where the surface faces along `direction` (unit, world), `second` across.
template <class T>
struct DirectionMixKind {
    T first;
    T second;
    Vec3 direction{0, 1, 0};
};

/// Unit squares or cubes in turn; that of the origin is `first`.
template <class T>
struct CheckerboardKind {
    std::variant<Mapping, PointMapping> mapping;
    T first;
    T second;
};

/// Dots of radius 0.35 in about half of the unit squares.
template <class T>
struct DotsKind {
    Mapping mapping;
    T inside;
    T outside;
};

/// Linear in both coordinates; v01 is at (0, 1).
template <class T>
struct BilerpKind {
    Mapping mapping;
    T v00;
    T v01;
    T v10;
    T v11;
};

/// An image, its first row at the top (v = 1).
struct ImageKind {
    Mapping mapping;
    std::shared_ptr<const Image> image;
    Wrap wrap = Wrap::repeat;
    bool nearest = false;
    float scale = 1;
    bool invert = false;  // one minus the scaled value, not below zero
};

/// As a number: a grey itself, alpha where the image has one, else the mean of R, G, B.
struct FloatImageKind : ImageKind {};

struct SpectrumImageKind : ImageKind {
    ColourUse use = ColourUse::albedo;
};

struct FbmKind {
    PointMapping mapping;
    Octaves octaves;
};

/// Turbulence.
struct WrinkledKind {
    PointMapping mapping;
    Octaves octaves;
};

/// Waves of a height that changes slowly.
struct WindyKind {
    PointMapping mapping;
};

/// A fixed ramp of colours along y, disturbed by fBm.
struct MarbleKind {
    PointMapping mapping;
    Octaves octaves;
    float scale = 1;
    float variation = 0.2F;
};

struct FloatKind {
    std::variant<ScaledKind<FloatTexture>, MixKind<FloatTexture>, DirectionMixKind<FloatTexture>,
                 CheckerboardKind<FloatTexture>, DotsKind<FloatTexture>, BilerpKind<FloatTexture>,
                 FloatImageKind, FbmKind, WrinkledKind, WindyKind>
        kind;
};

struct SpectrumKind {
    std::variant<ScaledKind<SpectrumTexture>, MixKind<SpectrumTexture>,
                 DirectionMixKind<SpectrumTexture>, CheckerboardKind<SpectrumTexture>,
                 DotsKind<SpectrumTexture>, BilerpKind<SpectrumTexture>, SpectrumImageKind,
                 MarbleKind>
        kind;
};

/// Linear RGB of an image at a place, scaled and inverted, not below zero: what an image light or a
/// normal map asks for.
Vec3 image_rgb(const ImageKind& image, const TexturePoint& point);

}  // namespace sunfleck
