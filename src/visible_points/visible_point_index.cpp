// Construction of the index: Morton sort, blocks, boxes.
#include "visible_points/visible_point_index.h"

#include "core/parallel.h"
#include "visible_points/morton_order.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kBlock = 4096;

/// Returns a box around a cylinder.
Box box_around(const Disc& cylinder, float radius) {
    Vec3 half;
    for (int c = 0; c < 3; ++c) {
        const float n = cylinder.normal[c];
        const float across = std::sqrt(std::max(0.0F, 1 - n * n));
        half[c] = cylinder.half_length * std::abs(n) + radius * across +
                  (std::abs(cylinder.position[c]) + cylinder.half_length) * 1e-6F;
    }
    return {cylinder.position - half, cylinder.position + half};
}

/// Returns a box around the kernel of that radius, which contains every photon that accepts()
/// allows.
Box box_of(const Disc& disc, float radius) {
    if (disc.is_in_medium()) return box_around(disc, radius);
    Vec3 half;
    for (int c = 0; c < 3; ++c) {
        const float n = disc.normal[c];
        const float across = std::sqrt(std::max(0.0F, 1 - n * n));
        // Along the disc's own normal a photon is at most kDiscFlatness / cos^2(30) + tan(30) radii
        // away, because the mean of two normals that differ by 60 degrees is tilted by 30.
        const float along = 0.92F * std::abs(n);
        half[c] = radius * std::min(1.23F, across + along) + std::abs(disc.position[c]) * 1e-6F;
    }
    return {disc.position - half, disc.position + half};
}

bool is_plain(const VisiblePoint& p) {
    return p.is_flat() && p.bsdf == kLambertian;
}

/// Data of all points together.
struct Whole {
    Box box;  // of the disc centres
    std::uint8_t kinds = 0;
    std::uint32_t last_pixel = 0;
    std::size_t points = 0;

    void extend(const Whole& other) {
        box.extend(other.box);
        kinds |= other.kinds;
        last_pixel = std::max(last_pixel, other.last_pixel);
        points += other.points;
    }
};

Whole whole_of(const VisiblePointLists& lists) {
    std::vector<Whole> parts(lists.size());
    parallel_for(lists.size(), [&](std::size_t l) {
        for (const VisiblePoint& point : lists[l]) {
            const Vec3& position = point.disc.position;
            parts[l].extend({{position, position}, point.disc.kinds, point.pixel, 1});
        }
    });
    Whole whole;
    for (const Whole& part : parts) whole.extend(part);
    return whole;
}

constexpr std::uint8_t kTaken = 1;
constexpr std::uint8_t kShared = 3;

/// Returns kShared for each pixel with more than one point.
std::vector<std::uint8_t> shared_pixels(const VisiblePointLists& lists, std::uint32_t last_pixel) {
    std::vector<std::uint8_t> pixels(std::size_t{last_pixel} + 1, 0);
    parallel_for(lists.size(), [&](std::size_t l) {
        for (const VisiblePoint& point : lists[l]) {
            std::atomic_ref<std::uint8_t> pixel(pixels[point.pixel]);
            if ((pixel.fetch_or(kTaken, std::memory_order_relaxed) & kTaken) != 0)
                pixel.store(kShared, std::memory_order_relaxed);
        }
    });
    return pixels;
}

MortonKeys in_order(const VisiblePointLists& lists, const MortonGrid& grid) {
    constexpr unsigned kSortedBits = 63;
    return in_morton_order(
        lists.size(), [&](std::size_t l) { return lists[l].size(); },
        [&](std::size_t l, std::size_t i) { return grid.code(lists[l][i].disc.position); },
        kSortedBits);
}

}  // namespace

VisiblePointIndex::VisiblePointIndex(VisiblePointLists lists, int max_depth)
    : max_depth_(max_depth) {
    const Whole whole = whole_of(lists);
    if (whole.points == 0) return;
    kinds_ = whole.kinds;
    const bool has_cylinders = kinds_ >> kKindsInMedia != 0;
    grid_ = MortonGrid(whole.box.low, whole.box.high);
    const MortonKeys order = in_order(lists, grid_);
    const std::vector<std::uint8_t> pixels = shared_pixels(lists, whole.last_pixel);
    points_.resize(order.size());
    blocks_.resize((order.size() + kWidth - 1) / kWidth);
    std::vector<Box> usual(blocks_.size());
    std::vector<Box> all(blocks_.size());
    plain_.resize(blocks_.size());
    need_sight_.resize(blocks_.size());
    if (has_cylinders) half_lengths_.resize(blocks_.size());
    static_assert(kBlock % kWidth == 0);
    parallel_blocks(order.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i % kWidth == 0) blocks_[i / kWidth] = {};
            points_[i] = lists[order[i].list][order[i].item];
            points_[i].shares_pixel = pixels[points_[i].pixel] == kShared;
            const std::uint8_t bit(1U << i % kWidth);
            if (is_plain(points_[i])) plain_[i / kWidth] |= bit;
            if (points_[i].needs_sight) need_sight_[i / kWidth] |= bit;
            blocks_[i / kWidth].set(i % kWidth, points_[i].disc);
            const Disc& disc = points_[i].disc;
            if (has_cylinders) half_lengths_[i / kWidth].values[i % kWidth] = disc.half_length;
            usual[i / kWidth].extend(box_of(disc, disc.usual_radius()));
            all[i / kWidth].extend(box_of(disc, disc.widest_radius()));
        }
    });
    usual_ = BlockBoxes(std::move(usual));
    all_ = BlockBoxes(std::move(all));
}

std::size_t VisiblePointIndex::bytes() const {
    return points_.size() * sizeof(VisiblePoint) + blocks_.size() * sizeof(DiscBlock) +
           half_lengths_.size() * sizeof(HalfLengths) + usual_.bytes() + all_.bytes();
}

}  // namespace sunfleck::engine
