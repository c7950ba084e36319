// The slots that a path's emission reads, as one point of the unit cube.
#pragma once

#include "random_numbers/primary_sample.h"
#include "random_numbers/sobol.h"

#include <array>
#include <cstddef>

namespace sunfleck {

inline constexpr std::size_t kMappedSlots = 5;  // EmissionSlot::position_u .. light
static_assert(kMappedSlots == kSobolDimensions && slot(EmissionSlot::light) + 1 == kMappedSlots);

/// Slots in (0,1).
using EmissionPoint = std::array<double, kMappedSlots>;

struct WeightedEmission {
    EmissionPoint point{};
    double weight = 1;  // positive
};

}  // namespace sunfleck
