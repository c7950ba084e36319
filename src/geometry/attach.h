// Attaches the shapes of a group to its Embree scene.
#pragma once

#include "geometry/built.h"

#include <cstdint>

namespace sunfleck::engine {

/// Makes the Embree scene of the group and attaches its shapes. The caller may attach further
/// geometry and then calls commit(). The group's address must not change from then on.
/// @param exact_number  Embree's geometry id of the exact shapes.
void attach_shapes(ShapeGroup& group, RTCDevice device, std::uint32_t exact_number);

}  // namespace sunfleck::engine
