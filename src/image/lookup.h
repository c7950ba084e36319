// Image lookup between texels and beyond edges.
//
// Coordinates: s from the left, t from the top, [0,1] over the image; the centre of texel i is at
// (i + 0.5) / n.
#pragma once

#include "image/image.h"

namespace sunfleck::engine {

/// Wrap mode beyond the edges (pbrt-v4, but for mirror). octahedral_sphere: the image is an
/// octahedral map of the sphere, whose edges are glued to each other.
enum class Wrap { repeat, black, clamp, octahedral_sphere, mirror };

/// Wrap modes along both axes.
struct Wraps {
    Wrap across = Wrap::repeat;
    Wrap down = Wrap::repeat;

    Wraps(Wrap both) : across(both), down(both) {}  // NOLINT: mostly both are the same
    /// @param across_edges, down_edges  not octahedral_sphere, unless they are the same.
    Wraps(Wrap across_edges, Wrap down_edges) : across(across_edges), down(down_edges) {}
};

/// Returns all channels as linear light, bilinearly interpolated between the four nearest texels.
std::array<float, 4> bilinear(const Image& image, const Vec2& place, const Wraps& wraps);

/// Returns all channels of the nearest texel as linear light.
std::array<float, 4> nearest(const Image& image, const Vec2& place, const Wraps& wraps);

}  // namespace sunfleck::engine
