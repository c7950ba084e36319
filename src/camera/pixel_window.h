// PixelWindow: the rectangle of the film that is rendered.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cstddef>

namespace sunfleck::engine {

/// Pixels [x0, x1) x [y0, y1) of the film in row-major order: pixel i of a pass.
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
    /// Returns the film point for camera_ray(). @param offset  from the centre of the pixel, in
    /// pixels.
    Vec2d place(std::size_t pixel, const Vec2d& offset) const {
        const auto columns = static_cast<std::size_t>(width());
        const std::size_t row = pixel / columns;
        return {x0 + static_cast<double>(pixel % columns) + 0.5 + offset.x,
                y0 + static_cast<double>(row) + 0.5 + offset.y};
    }
};

/// A grid of cells of `side` x `side` pixels, cropped at the right and lower edges, with one chosen
/// pixel per cell. The chosen pixels are sheared, so that each row and column of the window has
/// some.
struct PixelCells {
    PixelWindow window;
    int side = 1;

    int across() const { return (window.width() + side - 1) / side; }
    int down() const { return (window.height() + side - 1) / side; }
    /// Returns the chosen pixel of cell x, y.
    std::size_t pixel_of(int x, int y) const {
        const int u = std::min(x * side + y % side, window.width() - 1);
        const int v = std::min(y * side + x % side, window.height() - 1);
        return static_cast<std::size_t>(v) * static_cast<std::size_t>(window.width()) +
               static_cast<std::size_t>(u);
    }
    /// Returns the cell of a pixel, in row-major order.
    std::size_t cell_of(std::size_t pixel) const {
        const auto columns = static_cast<std::size_t>(window.width());
        const int x = static_cast<int>(pixel % columns) / side;
        const int y = static_cast<int>(pixel / columns) / side;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(across()) +
               static_cast<std::size_t>(x);
    }
    /// Returns whether this pixel is the chosen one of its cell.
    bool has(std::size_t pixel) const {
        if (side == 1) return true;
        const auto columns = static_cast<std::size_t>(window.width());
        return pixel_of(static_cast<int>(pixel % columns) / side,
                        static_cast<int>(pixel / columns) / side) == pixel;
    }
};

}  // namespace sunfleck::engine
