// Values of an image between its texels, and beyond its edges.
//
// Place: s from the left, t from the top, [0,1] over the image; texel i has its centre at
// (i + 0.5) / n.
#pragma once

#include "image/image.h"

namespace sunfleck::engine {

/// What is beyond the edges (pbrt-v4). octahedral_sphere: the image is an octahedral map of the
/// sphere, whose edges meet each other.
enum class Wrap { repeat, black, clamp, octahedral_sphere };

/// All channels at a place, linear light: between the four nearest texels, linear in s and in t.
std::array<float, 4> bilinear(const Image& image, const Vec2& place, Wrap wrap);

/// The same of the nearest texel.
std::array<float, 4> nearest(const Image& image, const Vec2& place, Wrap wrap);

}  // namespace sunfleck::engine
