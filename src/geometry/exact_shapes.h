// Quadrics, bilinear patches and curves inside Embree: its boxes, our intersection in double.
#pragma once

#include "geometry/built.h"

#include <cstdint>

namespace sunfleck::engine {

/// Lets Embree call the exact shapes of a group, which must stay where it is.
/// @param number  Embree's, for all of them together.
void attach_exact_shapes(ShapeGroup& group, RTCDevice device, std::uint32_t number);

}  // namespace sunfleck::engine
