// Builds the index: sort by Morton code, then blocks, then boxes.
#include "measurement/visible_point_index.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace sunfleck {
namespace {

constexpr std::size_t kBlock = 4096;

/// Half width of a box around the disc along each axis: every photon that takes() accepts is in.
Box box_of(const Disc& disc) {
    Vec3 half;
    for (int c = 0; c < 3; ++c) {
        const float n = disc.normal[c];
        const float across = std::sqrt(std::max(0.0F, 1 - n * n));
        // Along the disc's own normal a photon may be at most kDiscFlatness / cos^2(30) + tan(30)
        // radii away: the mean of two normals that differ by 60 degrees leans by 30.
        const float along = 0.92F * std::abs(n);
        half[c] =
            disc.radius * std::min(1.23F, across + along) + std::abs(disc.position[c]) * 1e-6F;
    }
    return {disc.position - half, disc.position + half};
}

bool is_plain(const VisiblePoint& p) {
    const bool same = p.shading_normal == p.disc.normal || p.shading_normal == -p.disc.normal;
    return same && p.bsdf == kLambertian;
}

/// By pixel: has it more than one point?
std::vector<bool> shared_pixels(const std::vector<VisiblePoint>& points) {
    std::uint32_t last = 0;
    for (const VisiblePoint& p : points) last = std::max(last, p.pixel);
    std::vector<bool> seen(std::size_t{last} + 1);
    std::vector<bool> shared(std::size_t{last} + 1);
    for (const VisiblePoint& p : points) {
        if (seen[p.pixel]) shared[p.pixel] = true;
        seen[p.pixel] = true;
    }
    return shared;
}

std::vector<MortonKey> morton_order(const std::vector<VisiblePoint>& points,
                                    const MortonGrid& grid) {
    std::vector<MortonKey> keys(points.size());
    parallel_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            keys[i] = {grid.code(points[i].disc.position), static_cast<std::uint32_t>(i), 0};
    });
    sort_by_code(keys, 63);
    return keys;
}

}  // namespace

VisiblePointIndex::VisiblePointIndex(std::vector<VisiblePoint> points, int max_depth)
    : max_depth_(max_depth) {
    if (points.empty()) return;
    Box all;
    for (const VisiblePoint& p : points) {
        all.extend({p.disc.position, p.disc.position});
        kinds_ |= p.disc.kinds;
    }
    grid_ = MortonGrid(all.low, all.high);
    const std::vector<MortonKey> order = morton_order(points, grid_);
    const std::vector<bool> shared = shared_pixels(points);
    points_.resize(points.size());
    blocks_.resize((points.size() + kWidth - 1) / kWidth);
    boxes_.resize(blocks_.size());
    plain_.resize(blocks_.size());
    static_assert(kBlock % kWidth == 0);
    parallel_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            points_[i] = points[order[i].item];
            points_[i].shares_pixel = shared[points_[i].pixel];
            if (is_plain(points_[i])) plain_[i / kWidth] |= std::uint8_t(1U << i % kWidth);
            blocks_[i / kWidth].set(i % kWidth, points_[i].disc);
            boxes_[i / kWidth].extend(box_of(points_[i].disc));
        }
    });
    tree_ = BoxTree(boxes_);
    occupancy_ = Occupancy(boxes_);
}

std::size_t VisiblePointIndex::bytes() const {
    return points_.size() * sizeof(VisiblePoint) +
           blocks_.size() * (sizeof(DiscBlock) + sizeof(Box)) + tree_.bytes() + occupancy_.bytes();
}

}  // namespace sunfleck
