// Alpha that is known as a function alone, as a texture.
#pragma once

#include "geometry/geometry_input.h"
#include "texture/texture.h"

#include <array>

namespace sunfleck::engine {

/// Texels per side of a picture of a mask.
inline constexpr int kMaskSide = 2048;

/// Part of the plane of texture coordinates that a mesh has: low u, low v, width, height.
using UvBox = std::array<float, 4>;

/// Returns the unit square, or the whole squares that hold all coordinates of a mesh.
UvBox uv_box(const PlacedShape& shape);

/// Returns a texture of alpha over a box, as the cover has it at each texel's middle.
/// @param cover  not null; it depends on the texture coordinates alone.
FloatTexture mask_of(const Cover& cover, const UvBox& box);

}  // namespace sunfleck::engine
