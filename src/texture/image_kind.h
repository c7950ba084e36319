// Image textures: lookup of an image on a surface, and the meaning of its texels.
#pragma once

#include "image/lookup.h"
#include "math/vector.h"
#include "texture/mapping.h"

#include <memory>

namespace sunfleck::engine {

/// Use of a spectrum, which decides how a texel's RGB becomes a spectrum.
enum class ColourUse {
    albedo,     // clamped to [0,1]
    unbounded,  // any non-negative quantity
    illuminant  // a non-negative quantity under D65
};

/// An image whose first row is at the top (v = 1).
struct ImageKind {
    Mapping mapping;
    std::shared_ptr<const Image> image;
    Wraps wraps = Wrap::repeat;
    bool nearest = false;
    float scale = 1;
    bool invert = false;  // use one minus the scaled value, at least zero
};

/// An image as numbers: grey itself, alpha if the image has it, else the mean of R, G, B.
struct FloatImageKind : ImageKind {};

struct SpectrumImageKind : ImageKind {
    ColourUse use = ColourUse::albedo;
};

/// Returns the number of an image at a point, scaled and inverted.
float image_number(const FloatImageKind& image, const TexturePoint& point);

/// Returns linear RGB of an image at a point, scaled and inverted, at least zero.
Vec3 image_rgb(const ImageKind& image, const TexturePoint& point);

}  // namespace sunfleck::engine
