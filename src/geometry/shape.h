// Every shape there is, as plain data in its own object frame. To add one: write its header, then
// name it here and in tests/laws/shape_examples.h.
#pragma once

#include "geometry/disk.h"
#include "geometry/sphere.h"
#include "geometry/triangle_mesh.h"

#include <variant>

namespace sunfleck {

using Shape = std::variant<TriangleMesh, Sphere, Disk>;

}  // namespace sunfleck
