// All kinds of textures except images alone, with the meaning of pbrt-v4; those of vertices are
// glTF's.
#pragma once

#include "math/vector.h"
#include "texture/image_kind.h"
#include "texture/mapping.h"
#include "texture/noise.h"

#include <optional>
#include <variant>

namespace sunfleck::engine {

/// texture * factor.
/// @tparam T  FloatTexture or SpectrumTexture, here and below; T::Number is the texture of numbers.
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

/// `first` where the normal is along `direction` (unit, world), `second` where it is perpendicular.
template <class T>
struct DirectionMixKind {
    T first;
    T second;
    Vec3 direction{0, 1, 0};
};

/// Alternating unit squares or cubes; the one at the origin is `first`.
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

/// Bilinear between the corners; v01 is at (0, 1).
template <class T>
struct BilerpKind {
    Mapping mapping;
    T v00;
    T v01;
    T v10;
    T v11;
};

/// Linear RGB of vertices, times an image where there is one, as a reflectance.
struct VertexColourKind {
    VertexValues<Vec3> colours;
    std::optional<ImageKind> image{};
};

/// Numbers of vertices.
struct VertexNumberKind {
    VertexValues<Vec2> numbers;  // the first of each
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

/// Waves whose height changes slowly.
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
