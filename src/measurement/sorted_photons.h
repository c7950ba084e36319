// The photons of many batches in Morton order, to be asked which of them are in a box.
#pragma once

#include "measurement/box_tree.h"
#include "measurement/morton.h"
#include "measurement/photon_batch.h"

#include <vector>

namespace sunfleck {

class SortedPhotons {
public:
    /// The order depends on the photons and on the order of the batches alone.
    SortedPhotons(const std::vector<PhotonBatch>& batches, const MortonGrid& grid);

    std::size_t size() const { return photons_.size(); }
    const Photon& operator[](std::size_t i) const { return photons_[i]; }

    /// Places to search for the photons in a box and in all boxes within it.
    using Places = std::vector<std::uint32_t>;
    void find_places(const Box& box, Places& places) const {
        places.clear();
        tree_.append_nodes(box, places);
    }
    /// Calls see(i) for every photon in the (closed) box, always in the same order.
    template <class See>
    void in_box(const Box& box, const Places& places, const See& see) const {
        for (const std::uint32_t place : places)
            for (unsigned leaves = tree_.touched(place, box); leaves != 0; leaves &= leaves - 1)
                in_leaf(box, place * kWidth + static_cast<unsigned>(__builtin_ctz(leaves)), see);
    }

    /// Writes taken[i] to where photon i came from.
    void hand_back(const std::vector<std::uint8_t>& taken, std::vector<PhotonBatch>& batches) const;

private:
    static constexpr std::size_t kWidth = BoxNode::kWidth;

    /// Positions of eight photons. Places that are not set are in no box.
    struct alignas(32) Leaf {
        std::array<std::array<float, kWidth>, 3> position;

        unsigned in_box(const Box& box) const {
            namespace hn = hwy::HWY_NAMESPACE;
            constexpr FourFloats kFour;
            return eight_bits([&](unsigned i) {
                const auto between = [&](std::size_t axis) {
                    const int c = static_cast<int>(axis);
                    const auto x = hn::Load(kFour, &position[axis][i]);
                    return hn::And(hn::Le(hn::Set(kFour, box.low[c]), x),
                                   hn::Le(x, hn::Set(kFour, box.high[c])));
                };
                return hn::And(between(0), hn::And(between(1), between(2)));
            });
        }
    };

    template <class See>
    void in_leaf(const Box& box, std::size_t leaf, const See& see) const {
        for (unsigned mask = leaves_[leaf].in_box(box); mask != 0; mask &= mask - 1)
            see(leaf * kWidth + static_cast<unsigned>(__builtin_ctz(mask)));
    }

    Box fill(std::size_t leaf);

    std::vector<MortonKey> order_;
    std::vector<Photon> photons_;
    std::vector<Leaf> leaves_;
    BoxTree tree_;  // over leaves
};

}  // namespace sunfleck
