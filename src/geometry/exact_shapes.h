// Quadrics, bilinear patches and curves as Embree user geometry, intersected by our code in double.
#pragma once

#include "geometry/built.h"

#include <cstdint>

namespace sunfleck::engine {

/// Registers the exact shapes of a group with Embree; the group's address must not change.
/// @param number  Embree's geometry id, one for all of them.
void attach_exact_shapes(ShapeGroup& group, RTCDevice device, std::uint32_t number);

}  // namespace sunfleck::engine
