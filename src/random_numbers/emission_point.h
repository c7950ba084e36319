// The dimensions that a path's emission reads, as one point of the unit cube.
#pragma once

#include "random_numbers/primary_sample.h"
#include "random_numbers/sobol.h"

#include <array>
#include <cstddef>

namespace sunfleck::engine {

inline constexpr std::size_t kGuidedDimensions = 5;  // EmissionDimension::position_u .. light
static_assert(kGuidedDimensions == kSobolDimensions &&
              dimension(EmissionDimension::light) + 1 == kGuidedDimensions);

/// Dimensions in (0,1).
using EmissionPoint = std::array<double, kGuidedDimensions>;

struct WeightedEmission {
    EmissionPoint point{};
    double weight = 1;  // positive
};

}  // namespace sunfleck::engine
