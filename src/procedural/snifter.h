// The curves of a smooth snifter of brandy.
#pragma once

#include "procedural/filled_glass.h"

namespace sunfleck::engine {

/// Vertices of each ring.
inline constexpr std::size_t kSnifterSegments = 256;

GlassCurves snifter_curves();

}  // namespace sunfleck::engine
