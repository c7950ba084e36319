// Occupancy: a bit grid of 64^3 cells that tells quickly where no gather disc is.
#pragma once

#include "visible_points/box_tree.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class Occupancy {
public:
    Occupancy() = default;
    /// Marks every cell that one of the boxes touches.
    explicit Occupancy(const std::vector<Box>& boxes);

    /// Returns false only if no box contains p.
    bool may_be_in_a_box(const Vec3& p) const {
        for (int c = 0; c < 3; ++c)
            if (!(p[c] >= bounds_.low[c] && p[c] <= bounds_.high[c])) return false;
        return (rows_[row(cell(p, 1), cell(p, 2))] >> cell(p, 0) & 1U) != 0;
    }

    std::size_t bytes() const { return rows_.size() * sizeof(std::uint64_t); }

private:
    static constexpr std::size_t kCells = 64;

    /// Returns the cell along an axis, a monotone function of p, so that points of a box are in its
    /// cells. p must be in bounds_.
    std::size_t cell(const Vec3& p, int axis) const {
        const float position = (p[axis] - bounds_.low[axis]) * cells_per_unit_;
        return std::min(kCells - 1, static_cast<std::size_t>(position));
    }
    static std::size_t row(std::size_t y, std::size_t z) { return z * kCells + y; }
    /// Thread-safe.
    void mark(const Box& box);

    Box bounds_;  // of all boxes
    float cells_per_unit_ = 0;
    std::vector<std::uint64_t> rows_;  // bits along x
};

}  // namespace sunfleck::engine
