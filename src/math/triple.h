// Three numbers in double that represent a colour.
#pragma once

#include <array>
#include <cstddef>

namespace sunfleck::engine {

/// XYZ or linear sRGB, as stated where it is used.
using Triple = std::array<double, 3>;

}  // namespace sunfleck::engine
