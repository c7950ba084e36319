// Units of glTF: photometric, in metres.
#pragma once

#include "light/lumens.h"

namespace sunfleck::engine {

/// The most candela, lux or nits of a light: a float holds what becomes of it.
inline constexpr double kMostLight = 1e30;

}  // namespace sunfleck::engine
