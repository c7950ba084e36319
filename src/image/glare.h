// Glare: light that the eye or a lens scatters around what is bright.
//
// A scattered share falls with the angle t from its source as 1/t^3 + 1/t^2, t in degrees: the
// glare of the eye between .2 and 10 degrees (Spencer et al. 1995; Vos 1984). The longer side of
// the picture is taken for 40 degrees. The law is a sum of Gaussians, each of four box filters.
#pragma once

#include "math/vector.h"

#include <vector>

namespace sunfleck::engine {

/// Scatters a fraction of the light of one channel. The sum of all pixels stays, but for rounding:
/// what would leave the picture is reflected at its border, so that an even picture stays even.
/// @param light  row by row, all finite.
/// @param fraction  in [0,1].
void add_glare(std::vector<float>& light, const Vec2i& size, double fraction);

}  // namespace sunfleck::engine
