// Meshes: primitives of glTF as triangles with shared vertices.
//
// Source: glTF 2.0 Specification, section 3.7: topologies, missing normals, morph targets, skins.
#pragma once

#include "core/warnings.h"
#include "geometry/triangle_mesh.h"
#include "import/gltf/nodes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// How a node shows a mesh.
struct MeshPose {
    std::vector<double> weights;  // of morph targets; may be empty
    /// Frames of a skin's joints, from the mesh as it is stored to the world; empty without a skin.
    std::vector<Matrix> joints;
    bool is_mirrored = false;  // the node's frame, which says which side of a skin is out

    bool is_rigid() const { return joints.empty(); }
};

/// Returns the pose of a node's mesh.
MeshPose pose_of(const GltfDocument& document, const GltfNodes& nodes, const Accessors& accessors,
                 const GltfNode& node, const JsonPlace& mesh);

/// Returns the triangles of a primitive; nothing for points and lines, of which a warning tells.
/// Without normals the mesh is flat.
/// @param uv_set  number of the texture coordinates to take.
/// @throws Error  for arrays that do not fit each other.
std::optional<TriangleMesh> triangles_of(const Accessors& accessors, const JsonPlace& primitive,
                                         const MeshPose& pose, std::uint64_t uv_set,
                                         Warnings& warnings);

}  // namespace sunfleck::engine
