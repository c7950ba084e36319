// BlockGrid: a picture's pixels in square blocks.
#pragma once

#include <algorithm>
#include <cstddef>

namespace sunfleck::engine {

/// The pixel rectangles of blocks; those at the right and lower edges may be smaller.
class BlockGrid {
public:
    struct Block {
        std::size_t x_begin, x_end, y_begin, y_end;
        std::size_t pixels() const { return (x_end - x_begin) * (y_end - y_begin); }
    };

    BlockGrid(int width, int height, std::size_t block_size)
        : width_(static_cast<std::size_t>(width)),
          height_(static_cast<std::size_t>(height)),
          size_(block_size) {}

    std::size_t side() const { return size_; }
    std::size_t across() const { return (width_ + size_ - 1) / size_; }
    std::size_t down() const { return (height_ + size_ - 1) / size_; }
    std::size_t count() const { return across() * down(); }

    Block block(std::size_t i) const {
        const std::size_t x = i % across() * size_;
        const std::size_t y = i / across() * size_;
        return {x, std::min(x + size_, width_), y, std::min(y + size_, height_)};
    }

    std::size_t block_of(std::size_t pixel) const {
        return pixel / width_ / size_ * across() + pixel % width_ / size_;
    }

    /// Calls visit(pixel) for each pixel of block i, row by row.
    template <class Visit>
    void for_pixels(std::size_t i, const Visit& visit) const {
        const Block b = block(i);
        for (std::size_t y = b.y_begin; y < b.y_end; ++y)
            for (std::size_t x = b.x_begin; x < b.x_end; ++x) visit(y * width_ + x);
    }

private:
    std::size_t width_;
    std::size_t height_;
    std::size_t size_;
};

}  // namespace sunfleck::engine
