// Photon lookup: which photons each visible point accepts, for blocks of points by SIMD.
//
// In:  an index of visible points, sorted photons. Out: the accepted photons per point. Results are
// the same for every instruction set.
#pragma once

#include "visible_points/sorted_photons.h"
#include "visible_points/visible_point_index.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// A photon, and the points of a block that accept it.
struct TakenPhoton {
    std::uint32_t photon = 0;     // index among the sorted photons
    std::uint32_t accepting = 0;  // bit i: point i of the block
};

/// The photons that some blocks accept, block by block.
struct TakenPhotons {
    static constexpr std::size_t kBlocks = 8;

    /// The range of one block in `list`.
    struct Block {
        std::size_t first = 0;
        std::size_t count = 0;
        std::uint32_t accepting = 0;  // bit i: point i accepts any photon
    };

    std::array<Block, kBlocks> blocks;
    std::vector<TakenPhoton> list;     // may be longer than the used part
    std::vector<std::uint32_t> nodes;  // nearby nodes of the photon tree
    std::vector<std::uint32_t> near;   // photons in the box of the current block
};

/// Lists the photons that blocks begin .. end - 1 accept, always in the same order; at most kBlocks
/// blocks that are close in space. @return whether there are any.
bool find_taken(const VisiblePointIndex& index, const SortedPhotons& photons, std::size_t begin,
                std::size_t end, TakenPhotons& taken);

}  // namespace sunfleck::engine
