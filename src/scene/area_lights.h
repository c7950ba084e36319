// Conversion of an emitting shape to area lights: one per triangle, one per quadric.
#pragma once

#include "scene/description.h"

#include <vector>

namespace sunfleck::engine {

/// @param shape  with an emission.
/// @param index  its Hit::shape.
/// @return light i is that of primitive i; triangles without area get lights without power.
std::vector<AreaLight> area_lights_of(const ShapeDescription& shape, std::uint32_t index);

}  // namespace sunfleck::engine
