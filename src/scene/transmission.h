// Whether surfaces of a material transmit light.
#pragma once

#include "material/material.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Returns whether light can continue behind surfaces of that material. If not, there are no paths
/// behind it, and it separates no media.
bool lets_light_through(const std::vector<Material>& materials, std::uint32_t material);

}  // namespace sunfleck::engine
