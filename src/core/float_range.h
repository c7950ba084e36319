// The range of floats, for numbers that were read in double.
#pragma once

#include <cmath>
#include <limits>

namespace sunfleck::engine {

/// Returns whether a number stays finite when it is rounded to float; false for NaN.
inline bool is_finite_float(double number) {
    return std::abs(number) <= double{std::numeric_limits<float>::max()};
}

}  // namespace sunfleck::engine
