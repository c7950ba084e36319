// "Does any disc take this photon?" and "which discs do?", for the visible points of a pass.
//
// In:  visible points. Out: those points in Morton order, eight to a block, under a tree of boxes
// around the blocks.
#pragma once

#include "measurement/box_tree.h"
#include "measurement/disc_block.h"
#include "measurement/morton.h"
#include "measurement/occupancy.h"
#include "measurement/visible_point.h"

#include <algorithm>
#include <vector>

namespace sunfleck {

class VisiblePointIndex {
public:
    /// @param max_depth  scattering events allowed on a whole path (takes()).
    VisiblePointIndex(std::vector<VisiblePoint> points, int max_depth);

    /// V of the paper for one photon: is it taken by any visible point? Ends at the first.
    bool any(const Photon& photon) const {
        return may_take(photon) && tree_.visit(photon.position, [&](std::uint32_t block) {
            return blocks_[block].takers(photon, max_depth_) == 0;
        });
    }

    /// V of a path: is any of its photons taken?
    bool any(const std::vector<Photon>& path) const {
        return std::any_of(path.begin(), path.end(),
                           [&](const Photon& photon) { return any(photon); });
    }

    /// Calls deposit(point) for every visible point that takes the photon.
    template <class Deposit>
    bool for_each(const Photon& photon, const Deposit& deposit) const {
        bool found = false;
        tree_.visit(photon.position, [&](std::uint32_t block) {
            const unsigned mask = blocks_[block].takers(photon, max_depth_);
            for (unsigned rest = mask; rest != 0; rest &= rest - 1)
                deposit(points_[block * kWidth + static_cast<unsigned>(__builtin_ctz(rest))]);
            found |= mask != 0;
            return true;
        });
        return found;
    }

    /// May any point take a photon there? A quick no for most places that are not seen.
    bool may_take(const Vec3& position) const { return occupancy_.may_be_in_a_box(position); }
    /// The same, knowing the kind.
    bool may_take(const Photon& photon) const {
        return takes_kind(photon.kind) && may_take(photon.position);
    }
    /// Does any point take such photons?
    bool takes_kind(PhotonKind kind) const {
        return (kinds_ & static_cast<std::uint8_t>(kind)) != 0;
    }

    /// Numbers near each other for places that the tree holds near each other.
    const MortonGrid& grid() const { return grid_; }

    /// Points 8 b .. 8 b + 7 (those that exist) are in block b.
    static constexpr std::size_t kWidth = DiscBlock::kWidth;
    std::size_t block_count() const { return blocks_.size(); }
    /// Bit i is set if point 8 b + i takes the photon.
    unsigned takers(std::size_t b, const Photon& photon) const {
        return blocks_[b].takers(photon, max_depth_);
    }
    /// Bit i is set if point 8 b + i is plain: Lambertian, and its shading normal is the geometric
    /// one, on either side. Its light is the photons' flux.
    unsigned plain(std::size_t b) const { return plain_[b]; }
    float radius(std::size_t b, std::size_t i) const { return blocks_[b].radius(i); }
    /// Holds every photon that a point of the block takes.
    const Box& box(std::size_t b) const { return boxes_[b]; }

    const std::vector<VisiblePoint>& points() const { return points_; }
    std::size_t bytes() const;

private:
    int max_depth_;
    std::uint8_t kinds_ = 0;  // that any point takes
    MortonGrid grid_;
    std::vector<VisiblePoint> points_;  // in Morton order
    std::vector<DiscBlock> blocks_;     // the same order: what a query reads
    std::vector<Box> boxes_;            // around blocks
    std::vector<std::uint8_t> plain_;   // one bit a point of a block
    BoxTree tree_;                      // over blocks
    Occupancy occupancy_;
};

}  // namespace sunfleck
