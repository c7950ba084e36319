// Film points that show the same direction: spherical cameras have several beyond the film's edges,
// where pixel filters reach across the seam, a pole or a fold.
#pragma once

#include "camera/camera.h"

#include <array>
#include <cstddef>

namespace sunfleck::engine {

/// A film point and its equivalents.
class FilmPoints {
public:
    void add(const Vec2d& point) { points_.at(count_++) = point; }
    const Vec2d* begin() const { return points_.data(); }
    const Vec2d* end() const { return points_.data() + count_; }

private:
    std::array<Vec2d, 9> points_;
    std::size_t count_ = 0;
};

/// Returns the point, and all others within half a film of the edges for which camera_ray() gives
/// the same direction. A flat film has no others.
/// @param film  in pixels; for a spherical camera it lies on the film.
FilmPoints film_images(const Camera& camera, const Vec2d& film);

}  // namespace sunfleck::engine
