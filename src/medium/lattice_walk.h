// The pieces of a line that lie in one cell each, or in one block of one value.
//
// Source: Amanatides and Woo, A Fast Voxel Traversal Algorithm (1987), on two levels.
#pragma once

#include "geometry/bounds.h"
#include "geometry/ray.h"
#include "medium/voxel_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunfleck::engine {

/// Points origin + t * direction of a lattice with begin < t < end.
struct LatticeLine {
    std::array<double, 3> origin;
    std::array<double, 3> direction;
    double begin = 0;
    double end = 0;

    /// The part of a line within bounds: nothing if begin is not less than end.
    LatticeLine(const Vec3d& from, const Vec3d& along, double length, const Bounds& bounds)
        : origin{from.x, from.y, from.z}, direction{along.x, along.y, along.z}, end(length) {
        clip(0, bounds.min.x, bounds.max.x);
        clip(1, bounds.min.y, bounds.max.y);
        clip(2, bounds.min.z, bounds.max.z);
    }

    double at(std::size_t axis, double t) const { return origin[axis] + direction[axis] * t; }

private:
    void clip(std::size_t axis, double low, double high) {
        if (direction[axis] == 0) {
            if (!(origin[axis] >= low && origin[axis] <= high)) end = begin;
            return;
        }
        const double to_low = (low - origin[axis]) / direction[axis];
        const double to_high = (high - origin[axis]) / direction[axis];
        begin = std::max(begin, std::min(to_low, to_high));
        end = std::min(end, std::max(to_low, to_high));
    }
};

/// The part of a line in one cell, or in one block of one value.
struct LatticePiece {
    double begin = 0;
    float length = 0;
    float constant = 0;             // the density, if there is no corner
    const float* corner = nullptr;  // lowest one, in the values of its block
    std::array<float, 3> start{};   // from the corner, in cells
    std::array<float, 3> direction{};

    /// Returns the density at a distance from the begin.
    float density(float distance) const {
        if (!corner) return constant;
        const auto mixed = [](float a, float b, float weight) { return a + (b - a) * weight; };
        const auto part = [&](std::size_t axis) {
            return start[axis] + direction[axis] * distance;
        };
        const float x = part(0);
        const float y = part(1);
        const auto along_x = [&](int j, int k) {
            const float* first = corner + VoxelBlocks::place(0, j, k);
            return mixed(first[0], first[1], x);
        };
        const float near = mixed(along_x(0, 0), along_x(1, 0), y);
        const float far = mixed(along_x(0, 1), along_x(1, 1), y);
        return std::max(0.0F, mixed(near, far, part(2)));  // rounding may leave less than nothing
    }
    /// Returns its integral from the begin to a distance: of a cubic, by the two points of Gauss
    /// and Legendre.
    float amount(float distance) const {
        if (!corner) return distance * constant;
        constexpr float kPoint = 0.21132487F;  // (1 - 1 / sqrt(3)) / 2
        return (density(kPoint * distance) + density((1 - kPoint) * distance)) * (distance / 2);
    }
    float amount() const { return amount(length); }
};

/// Steps along a line from one box of a lattice to the next.
template <class Real>
class BoxSteps {
public:
    /// @param origin  of the line, in the lattice; the first box is there.
    /// @param side  length of a box.
    /// @param count  number of boxes along each axis.
    BoxSteps(const std::array<Real, 3>& origin, const std::array<Real, 3>& direction, int side,
             const Voxel& count) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto last = static_cast<Real>(count[axis] - 1);
            const Real box = std::floor(origin[axis] / static_cast<Real>(side));
            at_[axis] = static_cast<int>(std::clamp(box, Real(0), last));
            const Real speed = direction[axis];
            step_[axis] = speed > 0 ? 1 : -1;
            left_[axis] = speed > 0 ? count[axis] - 1 - at_[axis] : at_[axis];
            if (speed == 0 || left_[axis] == 0) continue;
            const int border = side * (at_[axis] + (speed > 0 ? 1 : 0));
            next_[axis] = (static_cast<Real>(border) - origin[axis]) / speed;
            length_[axis] = std::abs(static_cast<Real>(side) / speed);
        }
        choose();
    }

    const Voxel& at() const { return at_; }
    /// Returns where the line leaves the box: infinity for the last one.
    Real exit() const { return next_[axis_]; }
    /// Goes on to the next box, if this is not the last one.
    void advance() {
        at_[axis_] += step_[axis_];
        next_[axis_] = --left_[axis_] == 0 ? kNever : next_[axis_] + length_[axis_];
        choose();
    }

private:
    static constexpr Real kNever = std::numeric_limits<Real>::infinity();

    void choose() {
        const std::size_t first = next_[0] < next_[1] ? 0 : 1;
        axis_ = next_[first] < next_[2] ? first : 2;
    }

    Voxel at_{};
    Voxel step_{};
    Voxel left_{};                                      // number of boxes that follow, by axis
    std::array<Real, 3> next_{kNever, kNever, kNever};  // where the line leaves, by axis
    std::array<Real, 3> length_{};                      // within a box, by axis
    std::size_t axis_ = 0;                              // along which it leaves first
};

namespace lattice_detail {

/// Floats within a block: their unit in the last place is 2^-21 of a cell.
/// @param whole  the piece in the block; its start is from the lowest corner of the block.
/// @return whether visit() wants more.
template <class Visit>
bool walk_block(const LatticePiece& whole, const float* values, const Visit& visit) {
    constexpr int kCells = VoxelBlocks::kCells;
    BoxSteps<float> cells(whole.start, whole.direction, 1, {kCells, kCells, kCells});
    LatticePiece piece = whole;
    float begin = 0;
    while (true) {
        const float end = std::clamp(cells.exit(), begin, whole.length);
        const Voxel& at = cells.at();
        piece.begin = whole.begin + static_cast<double>(begin);
        piece.length = end - begin;
        piece.corner = values + VoxelBlocks::place(at[0], at[1], at[2]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            piece.start[axis] =
                whole.start[axis] + whole.direction[axis] * begin - static_cast<float>(at[axis]);
        if (piece.length > 0 && !visit(piece)) return false;
        if (!(end < whole.length)) return true;
        begin = end;
        cells.advance();
    }
}

}  // namespace lattice_detail

/// Calls visit(piece) for pieces in order until it returns false. There may be none where all
/// values are zero.
template <class Visit>
void walk(const VoxelBlocks& voxels, const LatticeLine& line, const Visit& visit) {
    if (!(line.begin < line.end)) return;
    constexpr int kCells = VoxelBlocks::kCells;
    const std::array first = {line.at(0, line.begin), line.at(1, line.begin),
                              line.at(2, line.begin)};
    BoxSteps<double> blocks(first, line.direction, kCells, voxels.blocks());
    LatticePiece piece;
    double begin = 0;
    const double length = line.end - line.begin;
    while (true) {
        const double end = std::clamp(blocks.exit(), begin, length);
        const VoxelBlocks::Block block = voxels.block(blocks.at());
        piece.begin = line.begin + begin;
        piece.length = static_cast<float>(end - begin);
        piece.constant = block.constant;
        const bool is_there = piece.length > 0 && (block.values || block.constant > 0);
        if (is_there && block.values) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                piece.start[axis] = static_cast<float>(first[axis] + line.direction[axis] * begin -
                                                       blocks.at()[axis] * kCells);
                piece.direction[axis] = static_cast<float>(line.direction[axis]);
            }
            if (!lattice_detail::walk_block(piece, block.values, visit)) return;
        } else if (is_there && !visit(piece)) {
            return;
        }
        if (!(end < length)) return;
        begin = end;
        blocks.advance();
    }
}

}  // namespace sunfleck::engine
