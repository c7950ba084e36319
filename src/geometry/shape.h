// Shape: every alternative as plain data in its own object frame. To add one, write its header, add
// it here, and give examples in tests/laws/shape_examples.h.
#pragma once

#include "geometry/bilinear_mesh.h"
#include "geometry/curves.h"
#include "geometry/cylinder.h"
#include "geometry/disk.h"
#include "geometry/sphere.h"
#include "geometry/triangle_mesh.h"

#include <variant>

namespace sunfleck::engine {

using Shape = std::variant<TriangleMesh, Sphere, Disk, Cylinder, BilinearMesh, Curves>;

}  // namespace sunfleck::engine
