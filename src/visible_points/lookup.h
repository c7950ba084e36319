// Which photons do visible points take? Asked for many at once, with the widest instructions that
// the processor has: the same answers everywhere.
//
// In:  an index of visible points, sorted photons. Out: who accepts which.
#pragma once

#include "visible_points/sorted_photons.h"
#include "visible_points/visible_point_index.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// A photon, and which points of a block take it.
struct TakenPhoton {
    std::uint32_t photon = 0;     // of the sorted ones
    std::uint32_t accepting = 0;  // bit i: point i of the block
};

/// The photons that some blocks take: those of one block after those of the one before.
struct TakenPhotons {
    static constexpr std::size_t kBlocks = 8;

    /// What one block accepts: some of `list`.
    struct Block {
        std::size_t first = 0;
        std::size_t count = 0;
        std::uint32_t accepting = 0;  // points that take any
    };

    std::array<Block, kBlocks> blocks;
    std::vector<TakenPhoton> list;     // may be longer than what is taken
    std::vector<std::uint32_t> nodes;  // of the photons' tree that are near
    std::vector<std::uint32_t> near;   // photons in the box of the block at hand
};

/// Lists what blocks begin .. end - 1 take, always in the same order: kBlocks at most, neighbours
/// in space. @return whether they take anything.
bool find_taken(const VisiblePointIndex& index, const SortedPhotons& photons, std::size_t begin,
                std::size_t end, TakenPhotons& taken);

}  // namespace sunfleck::engine
