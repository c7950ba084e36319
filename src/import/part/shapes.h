// Shapes of a part: its triangles by material, glass divided into solid and thin.
#pragma once

#include "import/obj/mesh.h"
#include "import/part/look.h"
#include "scene/import_settings.h"

#include <functional>

namespace sunfleck::engine {

/// How a part stands in the world, and how its glass is meant.
struct PartPlacement {
    double metres_per_unit = 1;
    GlassRule glass = GlassRule::automatic;
};

/// Adds the shapes of a mesh to a scene. Vertices are in floats relative to a place near them, so
/// that parts far from the origin keep their shape. Closed components of glass or light face
/// outwards, however the file has them.
/// @param mesh  whose lists are used up.
/// @param look_of  a material of the mesh by its index, or kNoIndex.
void add_part_shapes(SceneDescription& scene, ObjMesh mesh, const PartPlacement& placement,
                     const std::function<const PartLook&(std::uint32_t)>& look_of);

}  // namespace sunfleck::engine
