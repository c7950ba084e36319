// An image as a texture: where it lies on a surface, and what its texels mean.
#pragma once

#include "image/lookup.h"
#include "math/vector.h"
#include "texture/mapping.h"

#include <memory>

namespace sunfleck::engine {

/// What a spectrum stands for: it says what the colour of a texel means.
enum class ColourUse {
    albedo,     // brought into [0,1]
    unbounded,  // any non-negative quantity
    illuminant  // likewise, under D65
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

/// The number of an image at a place, scaled and inverted.
float image_number(const FloatImageKind& image, const TexturePoint& point);

/// Linear RGB of an image at a place, scaled and inverted, not below zero.
Vec3 image_rgb(const ImageKind& image, const TexturePoint& point);

}  // namespace sunfleck::engine
