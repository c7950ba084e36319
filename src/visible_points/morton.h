// Morton order: items that are close in space are close in the list.
//
// Source: Morton 1966; bits are interleaved by shifts and masks.
#pragma once

#include "core/unfilled.h"
#include "math/vector.h"

#include <cstdint>

namespace sunfleck::engine {

struct MortonKey {
    std::uint64_t code = 0;
    std::uint32_t item = 0;
    std::uint32_t list = 0;  // index of the list, if items are in several lists
};

using MortonKeys = UnfilledVector<MortonKey>;

/// A cube of space divided into 2^21 cells per axis.
class MortonGrid {
public:
    MortonGrid() = default;
    /// Makes the smallest grid of cubic cells that contains the box.
    MortonGrid(const Vec3& low, const Vec3& high);

    /// Returns interleaved cell indices; points outside count as in the nearest cell.
    std::uint64_t code(const Vec3& p) const;

private:
    Vec3 low_{0};
    float cells_per_unit_ = 0;
};

/// Sorts stably by the upper `bits` of the 63 bits of a code. @param bits  1 to 63.
void sort_by_code(MortonKeys& keys, unsigned bits);

}  // namespace sunfleck::engine
