// An emitting shape becomes area lights: one a triangle, one a quadric.
#pragma once

#include "scene/description.h"

#include <vector>

namespace sunfleck::engine {

/// @param shape  with an emission. @param index  its Hit::shape.
/// @return light i is that of primitive i; triangles without area get lights without power.
std::vector<AreaLight> area_lights_of(const ShapeDescription& shape, std::uint32_t index);

}  // namespace sunfleck::engine
