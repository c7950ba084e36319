// The derivatives of a built shape around a hit.
#pragma once

#include "geometry/built.h"
#include "geometry/derivatives.h"
#include "geometry/ray.h"

namespace sunfleck::engine {

/// @param instance  that the hit is on, or null.
SurfaceDerivatives derivatives_at(const BuiltShape& shape, const BuiltInstance* instance,
                                  const Hit& hit);

}  // namespace sunfleck::engine
