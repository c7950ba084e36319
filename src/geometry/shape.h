// Every shape there is, as plain data in its own object frame. To add one: write its header, then
// name it here and in tests/laws/shape_examples.h.
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
