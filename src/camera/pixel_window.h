// The part of the film that is rendered.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cstddef>

namespace sunfleck::engine {

/// Pixels [x0, x1) x [y0, y1) of the film, row by row: pixel i of a pass.
struct PixelWindow {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    std::size_t pixels() const {
        return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
    }
    /// Where on the film, as camera_ray() takes it. @param offset  from the pixel's middle, in
    /// pixels.
    Vec2d place(std::size_t pixel, const Vec2d& offset) const {
        const auto columns = static_cast<std::size_t>(width());
        const std::size_t row = pixel / columns;
        return {x0 + static_cast<double>(pixel % columns) + 0.5 + offset.x,
                y0 + static_cast<double>(row) + 0.5 + offset.y};
    }
};

/// Cells of `side` x `side` pixels, those at the right and lower edges cut off, and one pixel of
/// each: sheared, so that no row and no column of the window goes without.
struct PixelCells {
    PixelWindow window;
    int side = 1;

    int across() const { return (window.width() + side - 1) / side; }
    int down() const { return (window.height() + side - 1) / side; }
    /// The one of cell x, y.
    std::size_t pixel_of(int x, int y) const {
        const int u = std::min(x * side + y % side, window.width() - 1);
        const int v = std::min(y * side + x % side, window.height() - 1);
        return static_cast<std::size_t>(v) * static_cast<std::size_t>(window.width()) +
               static_cast<std::size_t>(u);
    }
    /// Is this pixel the one of its cell?
    bool has(std::size_t pixel) const {
        if (side == 1) return true;
        const auto columns = static_cast<std::size_t>(window.width());
        return pixel_of(static_cast<int>(pixel % columns) / side,
                        static_cast<int>(pixel / columns) / side) == pixel;
    }
};

}  // namespace sunfleck::engine
