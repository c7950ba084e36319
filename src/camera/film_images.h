// Where a film shows one thing several times: around a spherical one, where filters reach beyond
// its edges and rays go on over the seam, a pole or a fold.
#pragma once

#include "camera/camera.h"

#include <vector>

namespace sunfleck {

/// The point, and all others less than half a film beyond the edges that camera_ray() takes to show
/// the same. Alone where the film is flat. @param film  in pixels; of a spherical camera on the
/// film.
std::vector<Vec2d> film_images(const Camera& camera, const Vec2d& film);

}  // namespace sunfleck
