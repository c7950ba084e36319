// Computes surface derivatives at a hit on a built shape.
#pragma once

#include "geometry/built.h"
#include "geometry/derivatives.h"
#include "geometry/ray.h"

namespace sunfleck::engine {

/// @param instance  instance that was hit, or null.
SurfaceDerivatives derivatives_at(const BuiltShape& shape, const BuiltInstance* instance,
                                  const Hit& hit);

}  // namespace sunfleck::engine
