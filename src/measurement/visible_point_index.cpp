// Builds the index: sort by Morton code, then boxes level by level.
#include "measurement/visible_point_index.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck {
namespace {

constexpr std::size_t kBlock = 4096;

struct Box {
    Vec3 low{std::numeric_limits<float>::infinity()};
    Vec3 high{-std::numeric_limits<float>::infinity()};

    void extend(const Box& other) {
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], other.low[c]);
            high[c] = std::max(high[c], other.high[c]);
        }
    }
};

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
    for (const VisiblePoint& p : points) all.extend({p.disc.position, p.disc.position});
    grid_ = MortonGrid(all.low, all.high);
    const std::vector<MortonKey> order = morton_order(points, grid_);
    points_.resize(points.size());
    discs_.resize(points.size());
    std::vector<Box> boxes(points.size());
    parallel_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            points_[i] = points[order[i].item];
            discs_[i] = points_[i].disc;
            boxes[i] = box_of(discs_[i]);
        }
    });
    do {
        const std::size_t count = (boxes.size() + kWidth - 1) / kWidth;
        std::vector<Node> level(count);
        std::vector<Box> parents(count);
        parallel_blocks(count, kBlock / kWidth, [&](std::size_t begin, std::size_t end) {
            for (std::size_t node = begin; node < end; ++node) {
                for (std::size_t i = 0; i < kWidth; ++i) {
                    const std::size_t child = node * kWidth + i;
                    const Box box = child < boxes.size() ? boxes[child] : Box{};
                    for (int c = 0; c < 3; ++c) {
                        const auto axis = static_cast<std::size_t>(c);
                        level[node].low.at(axis).at(i) = box.low[c];
                        level[node].high.at(axis).at(i) = box.high[c];
                    }
                    parents[node].extend(box);
                }
            }
        });
        levels_.push_back(std::move(level));
        boxes = std::move(parents);
    } while (boxes.size() > 1);
}

std::size_t VisiblePointIndex::bytes() const {
    std::size_t total = points_.size() * (sizeof(VisiblePoint) + sizeof(Disc));
    for (const auto& level : levels_) total += level.size() * sizeof(Node);
    return total;
}

}  // namespace sunfleck
