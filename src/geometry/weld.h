// Welder: makes vertices at one place one vertex.
#pragma once

#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Numbers positions in the order in which they first come. The table is a hash with open
/// addressing, a third to two thirds full.
class Welder {
public:
    /// Returns the number of a position; 0 and -0 are one. @param position  not NaN; fewer than
    /// 2^31 different ones.
    std::uint32_t number_of(const Vec3& position);

    /// All positions, by their numbers.
    const std::vector<Vec3>& positions() const { return positions_; }
    std::vector<Vec3> take_positions() { return std::move(positions_); }

private:
    void grow();
    std::size_t slot_of(const Vec3& position) const;

    std::vector<Vec3> positions_;
    std::vector<std::uint32_t> slots_;  // numbers plus 1; 0 is free
};

}  // namespace sunfleck::engine
