// Every kind of texture there is but images, with the meaning that pbrt-v4 gives it.
#pragma once

#include "math/vector.h"
#include "texture/mapping.h"
#include "texture/noise.h"

#include <variant>

namespace sunfleck::engine {

/// texture * factor.
/// @tparam T  the texture: FloatTexture or SpectrumTexture, here and below. T::Number is the
///            texture of numbers.
template <class T>
struct ScaledKind {
    T texture;
    typename T::Number factor;
};

/// first * (1 - amount) + second * amount.
template <class T>
struct MixKind {
    T first;
    T second;
    typename T::Number amount;
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

}  // namespace sunfleck::engine
