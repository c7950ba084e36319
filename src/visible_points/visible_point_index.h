// VisiblePointIndex: spatial index of the visible points of a pass, for visibility queries and
// deposits.
//
// In:  lists of visible points. Out: the points in Morton order in blocks of eight, under a tree of
// boxes.
#pragma once

#include "core/unfilled.h"
#include "visible_points/block_boxes.h"
#include "visible_points/disc_block.h"
#include "visible_points/morton.h"
#include "visible_points/visible_point.h"

#include <span>
#include <vector>

namespace sunfleck::engine {

class VisiblePointIndex {
public:
    /// @param max_depth  largest number of scattering events of whole paths.
    VisiblePointIndex(VisiblePointLists lists, int max_depth);

    /// Returns the visibility V of a path (Hachisuka and Jensen 2011): whether any visible point
    /// accepts any of its photons. It ends at the first.
    bool any(std::span<const Photon> path) const;
    bool any(const Photon& photon) const { return any({&photon, 1}); }

    /// Returns false fast for most photons that no point accepts.
    bool may_accept(const Photon& photon) const {
        return accepts_kind(photon) &&
               around(photon.kind).occupancy.may_be_in_a_box(photon.position);
    }
    /// Returns whether any point accepts such photons.
    bool accepts_kind(const Photon& photon) const { return (kinds_ & photon.kinds()) != 0; }

    /// Returns the grid of the Morton codes, for photons.
    const MortonGrid& grid() const { return grid_; }

    /// Block b holds points 8 b .. 8 b + 7 (those that exist).
    static constexpr std::size_t kWidth = DiscBlock::kWidth;
    std::size_t block_count() const { return blocks_.size(); }
    const DiscBlock& discs(std::size_t b) const { return blocks_[b]; }
    /// Returns whether any point is in a medium.
    bool has_cylinders() const { return !half_lengths_.empty(); }
    /// Returns the half lengths of the cylinders of a block. They stand apart, for most pictures
    /// have none.
    const DiscBlock::Floats& half_lengths(std::size_t b) const { return half_lengths_[b].values; }
    /// Returns a mask: bit i is set if point 8 b + i is Lambertian and its shading normal is the
    /// geometric one, on either side. Its light is the photons' flux.
    unsigned plain(std::size_t b) const { return plain_[b]; }
    /// Returns a mask of the points that need sight.
    unsigned need_sight(std::size_t b) const { return need_sight_[b]; }
    /// Returns the radius of point i of block b for photons of this kind.
    float radius(std::size_t b, std::size_t i, PhotonKind kind) const {
        const DiscBlock& discs = blocks_[b];
        return radius_of_kind(kind, discs.radius[i], discs.indirect_radius[i]);
    }
    /// Returns boxes that contain every photon of this kind that a point of the block accepts. Long
    /// specular chains have boxes of their own, because theirs are larger and would slow down all
    /// queries for few photons.
    const BlockBoxes& around(PhotonKind kind) const {
        return kind == PhotonKind::long_specular_chain ? all_ : usual_;
    }
    int max_depth() const { return max_depth_; }

    std::span<const VisiblePoint> points() const { return points_; }
    std::size_t bytes() const;

private:
    int max_depth_;
    std::uint8_t kinds_ = 0;  // kinds that any point accepts
    MortonGrid grid_;
    UnfilledVector<VisiblePoint> points_;  // in Morton order
    UnfilledVector<DiscBlock> blocks_;     // in the same order: the data of a query
    struct alignas(32) HalfLengths {
        DiscBlock::Floats values{};
    };
    std::vector<HalfLengths> half_lengths_;  // by block; empty if no point is in a medium
    std::vector<std::uint8_t> plain_;        // a bit per point of a block
    std::vector<std::uint8_t> need_sight_;
    BlockBoxes usual_;  // around accepted photons, long specular chains aside
    BlockBoxes all_;
};

}  // namespace sunfleck::engine
