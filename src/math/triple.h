// Three numbers in double that stand for a colour.
#pragma once

#include <array>
#include <cstddef>

namespace sunfleck::engine {

/// XYZ or linear sRGB, as said where it is used.
using Triple = std::array<double, 3>;

}  // namespace sunfleck::engine
