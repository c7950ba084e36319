// Clear coats over other materials.
#pragma once

#include "bsdf/coat.h"
#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"

#include <memory>
#include <string>

namespace sunfleck::engine {

/// How a material names its coat, and what it is when nothing is said.
struct CoatWords {
    std::string prefix{};  // of the names of the parameters: "" or "interface."
    float eta = 1.5F;
    double thickness = 0.01;
};

/// @throws Error for parameters that cannot be used.
std::shared_ptr<const Coat> coat_of(const Statement& statement, const CoatWords& words,
                                    Assets& assets);

}  // namespace sunfleck::engine
