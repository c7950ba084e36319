// "Does any disc take this photon?" and "which discs do?", for the visible points of a pass.
//
// In:  lists of visible points. Out: those points in Morton order, eight to a block, under a tree
// of boxes around the blocks.
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
    /// @param max_depth  scattering events of whole paths, at most.
    VisiblePointIndex(VisiblePointLists lists, int max_depth);

    /// V of the paper for a path: is any of its photons taken by any visible point? Ends at the
    /// first.
    bool any(std::span<const Photon> path) const;
    bool any(const Photon& photon) const { return any({&photon, 1}); }

    /// May any point take it? A quick no for most photons in places that are not seen.
    bool may_accept(const Photon& photon) const {
        return accepts_kind(photon.kind) &&
               around(photon.kind).occupancy.may_be_in_a_box(photon.position);
    }
    /// Does any point take such photons?
    bool accepts_kind(PhotonKind kind) const {
        return (kinds_ & static_cast<std::uint8_t>(kind)) != 0;
    }

    /// Numbers near each other for places that the tree holds near each other.
    const MortonGrid& grid() const { return grid_; }

    /// Points 8 b .. 8 b + 7 (those that exist) are in block b.
    static constexpr std::size_t kWidth = DiscBlock::kWidth;
    std::size_t block_count() const { return blocks_.size(); }
    const DiscBlock& discs(std::size_t b) const { return blocks_[b]; }
    /// Bit i is set if point 8 b + i is plain: Lambertian, and its shading normal is the geometric
    /// one, on either side. Its light is the photons' flux.
    unsigned plain(std::size_t b) const { return plain_[b]; }
    /// Of point i of block b, for photons of this kind.
    float radius(std::size_t b, std::size_t i, PhotonKind kind) const {
        const DiscBlock& discs = blocks_[b];
        return radius_of_kind(kind, discs.radius[i], discs.indirect_radius[i]);
    }
    /// Boxes that hold every photon of this kind that a point of the block accepts. Those for deep
    /// caustics hold the others: they would make all questions dearer for the sake of few photons.
    const BlockBoxes& around(PhotonKind kind) const {
        return kind == PhotonKind::long_specular_chain ? all_ : usual_;
    }
    int max_depth() const { return max_depth_; }

    std::span<const VisiblePoint> points() const { return points_; }
    std::size_t bytes() const;

private:
    int max_depth_;
    std::uint8_t kinds_ = 0;  // that any point accepts
    MortonGrid grid_;
    UnfilledVector<VisiblePoint> points_;  // in Morton order
    UnfilledVector<DiscBlock> blocks_;     // the same order: what a query reads
    std::vector<std::uint8_t> plain_;      // one bit a point of a block
    BlockBoxes usual_;                     // around what points take but long specular chains
    BlockBoxes all_;
};

}  // namespace sunfleck::engine
