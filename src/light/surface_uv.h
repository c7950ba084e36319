// Texture coordinates at points of an emitting surface.
#pragma once

#include "light/emitting_surface.h"

#include <array>

namespace sunfleck::engine {

/// (u, v) at the corners of a triangle (the first three) or of a patch; of no meaning for others.
using CornerUvs = std::array<Vec2, 4>;

/// Have the corners of the surface texture coordinates of their own?
bool has_corners(const EmittingSurface& surface);

/// (u, v) at a point of the surface, as a hit there has it.
/// @param normal  of the surface there, unit, either side.
Vec2 uv_at(const EmittingSurface& surface, const CornerUvs& uvs, const Vec3d& on,
           const Vec3d& normal);

}  // namespace sunfleck::engine
