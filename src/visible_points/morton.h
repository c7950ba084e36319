// Morton order: points near each other in space stand near each other in the list.
//
// Source: Morton 1966; bits are spread by the usual shifts and masks.
#pragma once

#include "core/unfilled.h"
#include "math/vector.h"

#include <cstdint>

namespace sunfleck::engine {

struct MortonKey {
    std::uint64_t code = 0;
    std::uint32_t item = 0;
    std::uint32_t list = 0;  // where items stand in several lists
};

using MortonKeys = UnfilledVector<MortonKey>;

/// A cube of space cut into 2^21 cells an axis.
class MortonGrid {
public:
    MortonGrid() = default;
    /// The smallest grid of cubic cells that holds the box.
    MortonGrid(const Vec3& low, const Vec3& high);

    /// Interleaved cell numbers; points outside count as in the cell nearest to them.
    std::uint64_t code(const Vec3& p) const;

private:
    Vec3 low_{0};
    float cells_per_unit_ = 0;
};

/// Sorts by the upper `bits` of the 63 of a code; equal ones keep their order. @param bits  1
/// to 63.
void sort_by_code(MortonKeys& keys, unsigned bits);

}  // namespace sunfleck::engine
