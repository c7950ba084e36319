// Lines through the blocks and cells of a lattice.
#include "medium/density_grid.h"

#include "medium/lattice_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr int kMostNewtonSteps = 64;
constexpr float kPieceShare = 1e-6F;  // of the length of a line in a cell

/// Returns the integral from minus infinity to x of max(0, 1 - |x|).
double tent_below(double x) {
    if (x <= 0) return x <= -1 ? 0 : (x + 1) * (x + 1) / 2;
    return x >= 1 ? 1 : 1 - (1 - x) * (1 - x) / 2;
}

/// Returns the weight of each point of an axis in the integral from low to high.
std::vector<double> weights_of(int cells, double low, double high) {
    std::vector<double> weights;
    for (int i = 0; i <= cells; ++i) weights.push_back(tent_below(high - i) - tent_below(low - i));
    return weights;
}

using Weights = std::array<std::vector<double>, 3>;

/// Returns the sum over the points of a block that no block before it has.
double weighted_sum(const VoxelBlocks::Block& block, const Weights& weights, const Voxel& at) {
    std::array<std::vector<double>, 3> own;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto begin = static_cast<std::size_t>(at[axis]) * VoxelBlocks::kCells;
        own[axis].assign(VoxelBlocks::kPoints, 0);
        for (std::size_t i = at[axis] == 0 ? 0 : 1; i < VoxelBlocks::kPoints; ++i)
            if (begin + i < weights[axis].size()) own[axis][i] = weights[axis][begin + i];
    }
    double sum = 0;
    const float* value = block.values;
    for (const double z : own[2])
        for (const double y : own[1])
            for (const double x : own[0]) sum += x * y * z * (value ? *value++ : block.constant);
    return sum;
}

/// Returns the distance from a piece's begin with that amount, which is less than the whole.
/// Newton's method, with bisection where it leaves the bracket.
float distance_within(const LatticePiece& piece, float whole, float amount) {
    float low = 0;
    float high = piece.length;
    const float precision = kPieceShare * high;
    float distance = high * (amount / whole);
    for (int step = 0; step < kMostNewtonSteps && high - low > precision; ++step) {
        const float excess = piece.amount(distance) - amount;
        (excess > 0 ? high : low) = distance;
        const float move = excess / piece.density(distance);
        if (std::abs(move) <= precision) break;
        const float next = distance - move;
        distance = next > low && next < high ? next : low + (high - low) / 2;
    }
    return distance;
}

}  // namespace

DensityGrid::DensityGrid(std::shared_ptr<const VoxelBlocks> voxels, const Bounds& bounds,
                         const Affine& to_world)
    : voxels_(std::move(voxels)),
      bounds_(bounds),
      to_world_(to_world),
      to_grid_(to_world.inverse()) {}

DensityGrid DensityGrid::moved(const Vec3d& by) const {
    Affine there = to_world_;
    there.origin += by;
    return {voxels_, bounds_, there};
}

DensityGrid DensityGrid::whole() const {
    const Voxel& cells = voxels_->cells();
    return {voxels_, {Vec3d(0), Vec3d(cells[0], cells[1], cells[2])}, to_world_};
}

LatticeLine DensityGrid::line_of(const Ray& way) const {
    return {to_grid_.point(Vec3d(way.origin)), to_grid_.vector(Vec3d(way.direction)), way.length,
            bounds_};
}

float DensityGrid::at(const Vec3& point) const {
    const LatticeLine line(to_grid_.point(Vec3d(point)), Vec3d(0), 1, bounds_);
    float found = 0;
    walk(*voxels_, line, [&](const LatticePiece& piece) {
        found = piece.density(0);
        return false;
    });
    return found;
}

float DensityGrid::amount(const Ray& way) const {
    double sum = 0;
    walk(*voxels_, line_of(way), [&](const LatticePiece& piece) {
        sum += static_cast<double>(piece.amount());
        return true;
    });
    return static_cast<float>(sum);
}

float DensityGrid::distance_at(const Ray& way, float amount) const {
    double left = amount;
    double distance = 0;
    walk(*voxels_, line_of(way), [&](const LatticePiece& piece) {
        const float whole = piece.amount();
        if (left < whole) {
            distance = piece.begin + distance_within(piece, whole, static_cast<float>(left));
            return false;
        }
        if (whole > 0) distance = piece.begin + piece.length;
        left -= whole;
        return true;
    });
    return std::min(static_cast<float>(distance), way.length);
}

/// The density is a sum over points, each times the tents of three axes.
float DensityGrid::mean() const {
    const Vec3d size = bounds_.max - bounds_.min;
    const std::array weights = {weights_of(voxels_->cells()[0], bounds_.min.x, bounds_.max.x),
                                weights_of(voxels_->cells()[1], bounds_.min.y, bounds_.max.y),
                                weights_of(voxels_->cells()[2], bounds_.min.z, bounds_.max.z)};
    const Voxel& blocks = voxels_->blocks();
    double sum = 0;
    for (int z = 0; z < blocks[2]; ++z)
        for (int y = 0; y < blocks[1]; ++y)
            for (int x = 0; x < blocks[0]; ++x)
                sum += weighted_sum(voxels_->block({x, y, z}), weights, {x, y, z});
    return static_cast<float>(sum / (size.x * size.y * size.z));
}

}  // namespace sunfleck::engine
