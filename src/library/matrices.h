// Transforms of the interface as matrices of the engine, which multiplies rows from the left.
#pragma once

#include "math/vector.h"
#include "sunfleck/transform.h"

namespace sunfleck {

engine::Matrix matrix_of(const Transform& transform);
Transform transform_of(const engine::Matrix& matrix);

}  // namespace sunfleck
