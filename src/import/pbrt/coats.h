// Clear coats of materials.
#pragma once

#include "bsdf/coat.h"
#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"

#include <memory>
#include <string>

namespace sunfleck::engine {

/// Prefix and defaults of the coat parameters of a material.
struct CoatWords {
    std::string prefix{};  // of parameter names: "" or "interface."
    float eta = 1.5F;
    double thickness = 0.01;
};

/// @throws Error  for parameters that cannot be used.
std::shared_ptr<const Coat> coat_of(const Statement& statement, const CoatWords& words,
                                    Assets& assets);

}  // namespace sunfleck::engine
