// Small moves of a path's numbers.
#include "reference/path_numbers.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Kelemen et al. 2002, section 3.1: moves between these, their logarithms uniform.
constexpr double kLeastMove = 1.0 / 1024;
constexpr double kMostMove = 1.0 / 64;

}  // namespace

/// To either side, around the ends of (0,1). @param u  in (0,1): side and size.
double PathNumbers::moved(double value, double u) {
    const double side = u < 0.5 ? 1 : -1;
    const auto along = static_cast<float>(u < 0.5 ? 2 * u : 2 * u - 1);
    static const float span = std::log(static_cast<float>(kMostMove / kLeastMove));
    const double size = kMostMove * static_cast<double>(std::exp(-span * along));
    const double sum = value + side * size;
    return std::clamp(sum - std::floor(sum), 0x1p-53, 1 - 0x1p-53);
}

}  // namespace sunfleck::engine
