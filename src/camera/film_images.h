// Where a film shows one thing several times: around a spherical one, where filters reach beyond
// its edges and rays go on over the seam, a pole or a fold.
#pragma once

#include "camera/camera.h"

#include <array>
#include <cstddef>

namespace sunfleck::engine {

/// Points of a film, and around it.
class FilmPoints {
public:
    void add(const Vec2d& point) { points_.at(count_++) = point; }
    const Vec2d* begin() const { return points_.data(); }
    const Vec2d* end() const { return points_.data() + count_; }

private:
    std::array<Vec2d, 9> points_;
    std::size_t count_ = 0;
};

/// The point, and all others less than half a film beyond the edges that camera_ray() takes to show
/// the same. Alone where the film is flat. @param film  in pixels; of a spherical camera on the
/// film.
FilmPoints film_images(const Camera& camera, const Vec2d& film);

}  // namespace sunfleck::engine
