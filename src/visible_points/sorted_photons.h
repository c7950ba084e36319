// The photons of many chunks in Morton order, long specular chains last, to be asked which of them
// are in a box.
#pragma once

#include "visible_points/box_tree.h"
#include "visible_points/morton.h"
#include "visible_points/photon_chunk.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {

/// Positions of eight photons. Places that are not set are in no box.
struct alignas(32) PhotonLeaf {
    std::array<std::array<float, BoxNode::kWidth>, 3> position;
};

class SortedPhotons {
public:
    /// The order depends on the photons and on the order of the chunks alone.
    SortedPhotons(const std::vector<PhotonChunk>& chunks, const MortonGrid& grid);

    std::size_t size() const { return photons_.size(); }
    const Photon& operator[](std::size_t i) const { return photons_[i]; }
    /// A kind whose boxes hold photons 0 .. end - 1. @param end  may be beyond the last.
    PhotonKind widest_before(std::size_t end) const {
        return first_deep_ < std::min(end, size()) ? PhotonKind::long_specular_chain
                                                   : PhotonKind::direct;
    }

    /// Photons 8 l .. 8 l + 7.
    const PhotonLeaf& leaf(std::size_t l) const { return leaves_[l]; }
    /// Over leaves.
    const BoxTree& tree() const { return tree_; }

    /// Writes taken[i] to where photon i came from.
    void hand_back(const std::vector<std::uint8_t>& taken, std::vector<PhotonChunk>& chunks) const;

private:
    static constexpr std::size_t kWidth = BoxNode::kWidth;

    Box fill(std::size_t leaf);

    MortonKeys order_;
    UnfilledVector<Photon> photons_;
    UnfilledVector<PhotonLeaf> leaves_;
    BoxTree tree_;
    std::size_t first_deep_ =
        0;  // photons from this one on are long specular chains, and no others
};

}  // namespace sunfleck::engine
