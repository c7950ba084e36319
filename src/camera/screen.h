// Maps between film, screen and lens of a camera with a flat film, for camera rays and their
// inverse.
#pragma once

#include "camera/screen_camera.h"
#include "math/warp.h"

#include <cmath>

namespace sunfleck::engine {

/// Matrix without its translation, applied to v.
inline Vec3d turn(const Matrix& matrix, const Vec3d& v) {
    Vec3d result;
    matrix.multDirMatrix(v, result);
    return result;
}

/// Volume that the unit cube gets.
inline double volume_scale(const Matrix& matrix) {
    const Vec3d x = turn(matrix, {1, 0, 0});
    const Vec3d y = turn(matrix, {0, 1, 0});
    return std::abs(x.cross(y).dot(turn(matrix, {0, 0, 1})));
}

/// Size of a pixel on the screen.
inline Vec2d pixel_of(const ScreenCamera& camera) {
    const Vec2d screen = camera.screen_max - camera.screen_min;
    return {screen.x / camera.resolution.x, screen.y / camera.resolution.y};
}

/// A film point on the screen.
inline Vec2d on_screen(const ScreenCamera& camera, const Vec2d& film) {
    const Vec2d pixel = pixel_of(camera);
    return {camera.screen_min.x + film.x * pixel.x, camera.screen_max.y - film.y * pixel.y};
}

/// The inverse of on_screen().
inline Vec2d film_point(const ScreenCamera& camera, const Vec2d& screen) {
    const Vec2d pixel = pixel_of(camera);
    return {(screen.x - camera.screen_min.x) / pixel.x, (camera.screen_max.y - screen.y) / pixel.y};
}

/// A point of the lens, camera frame. @param lens  in (0,1)^2.
inline Vec3d on_lens(const ScreenCamera& camera, const Vec2d& lens) {
    const Vec2d point =
        camera.lens_radius > 0 ? concentric_disc(lens) * camera.lens_radius : Vec2d(0);
    return {point.x, point.y, 0};
}

}  // namespace sunfleck::engine
