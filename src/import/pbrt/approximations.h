// Approximations of pbrt-v4's materials that are not simulated, with the same energy and colour.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "material/material.h"

namespace sunfleck::engine {

/// Approximates hair by diffuse reflection and transmission of each fibre
/// (material/fibre_albedo.h).
Material approximate_hair(const Statement& statement, Assets& assets);
/// Approximates a measured material by a metal of similar roughness, or by a diffuse one.
Material approximate_measured(const Statement& statement, Assets& assets);

}  // namespace sunfleck::engine
