// SortedPhotons: the photons of several chunks in Morton order with a tree, long specular chains
// last, for box queries.
#pragma once

#include "visible_points/box_tree.h"
#include "visible_points/morton.h"
#include "visible_points/photon_chunk.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {

/// Positions of eight photons. Unset places are in no box.
struct alignas(32) PhotonLeaf {
    std::array<std::array<float, BoxNode::kWidth>, 3> position;
};

class SortedPhotons {
public:
    /// The order depends on the photons and the order of the chunks alone.
    SortedPhotons(const std::vector<PhotonChunk>& chunks, const MortonGrid& grid);

    std::size_t size() const { return photons_.size(); }
    const Photon& operator[](std::size_t i) const { return photons_[i]; }
    /// Returns the chunk that photon i came from, and its place there.
    const MortonKey& origin(std::size_t i) const { return order_[i]; }
    /// Returns a kind whose boxes contain photons 0 .. end - 1. @param end  may be beyond the last
    /// photon.
    PhotonKind widest_before(std::size_t end) const {
        return first_deep_ < std::min(end, size()) ? PhotonKind::long_specular_chain
                                                   : PhotonKind::direct;
    }

    /// Returns photons 8 l .. 8 l + 7.
    const PhotonLeaf& leaf(std::size_t l) const { return leaves_[l]; }
    /// Returns the tree over leaves.
    const BoxTree& tree() const { return tree_; }

    /// Copies taken[i] back to the chunk that photon i came from.
    void hand_back(const std::vector<std::uint8_t>& taken, std::vector<PhotonChunk>& chunks) const;

private:
    static constexpr std::size_t kWidth = BoxNode::kWidth;

    Box fill(std::size_t leaf);

    MortonKeys order_;
    UnfilledVector<Photon> photons_;
    UnfilledVector<PhotonLeaf> leaves_;
    BoxTree tree_;
    std::size_t first_deep_ = 0;  // index of the first long specular chain
};

}  // namespace sunfleck::engine
