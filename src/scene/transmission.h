// Which surfaces let light through.
#pragma once

#include "material/material.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Does any light go on beyond surfaces of that material? Behind others there is no path, so that
/// they part no media.
bool lets_light_through(const std::vector<Material>& materials, std::uint32_t material);

}  // namespace sunfleck::engine
