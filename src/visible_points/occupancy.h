// A coarse answer to "is there any disc around here?": one bit for each cell of a cube of 64^3.
#pragma once

#include "visible_points/box_tree.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class Occupancy {
public:
    Occupancy() = default;
    /// VisibleFlags every cell that one of the boxes touches.
    explicit Occupancy(const std::vector<Box>& boxes);

    /// False only where no box is.
    bool may_be_in_a_box(const Vec3& p) const {
        for (int c = 0; c < 3; ++c)
            if (!(p[c] >= bounds_.low[c] && p[c] <= bounds_.high[c])) return false;
        return (rows_[row(cell(p, 1), cell(p, 2))] >> cell(p, 0) & 1U) != 0;
    }

    std::size_t bytes() const { return rows_.size() * sizeof(std::uint64_t); }

private:
    static constexpr std::size_t kCells = 64;

    /// Never falls as p grows, so that a point of a box is in a cell of the box. p is in bounds_.
    std::size_t cell(const Vec3& p, int axis) const {
        const float position = (p[axis] - bounds_.low[axis]) * cells_per_unit_;
        return std::min(kCells - 1, static_cast<std::size_t>(position));
    }
    static std::size_t row(std::size_t y, std::size_t z) { return z * kCells + y; }
    /// Any number of threads.
    void mark(const Box& box);

    Box bounds_;  // of all
    float cells_per_unit_ = 0;
    std::vector<std::uint64_t> rows_;  // along x
};

}  // namespace sunfleck::engine
