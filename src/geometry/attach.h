// Fills the Embree scene of a group with its shapes.
#pragma once

#include "geometry/built.h"

#include <cstdint>

namespace sunfleck::engine {

/// Makes the group's scene and attaches its shapes; what remains is more geometry, and commit().
/// The group must stay where it is from then on.
/// @param exact_number  Embree's number for the shapes that are intersected exactly.
void attach_shapes(ShapeGroup& group, RTCDevice device, std::uint32_t exact_number);

}  // namespace sunfleck::engine
