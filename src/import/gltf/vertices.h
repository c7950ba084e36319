// What the vertices of a primitive carry beside the mesh: colours, and other texture coordinates.
#pragma once

#include "geometry/triangle_mesh.h"
#include "import/gltf/accessors.h"
#include "texture/mapping.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace sunfleck::engine {

struct GltfVertices {
    std::uint64_t own_set = 0;  // number of the texture coordinates of the mesh
    bool has_own_set = true;    // the mesh has them
    std::shared_ptr<const VertexValues<Vec2>::Triangles> triangles{};
    /// Other texture coordinates, (u, 1 - v), by their number.
    std::map<std::uint64_t, std::shared_ptr<const std::vector<Vec2>>> other_sets{};
    std::shared_ptr<const std::vector<Vec3>> colours{};  // linear RGB; null for white
    std::shared_ptr<const std::vector<Vec2>> alphas{};   // the first of each; null for 1

    /// Returns whether a material may be shared with primitives that have other vertices.
    bool are_plain() const { return other_sets.empty() && !colours; }
};

/// Returns what a primitive's vertices carry.
/// @param uv_sets  numbers of texture coordinates; the first are those of the mesh.
/// @param mesh  the primitive's triangles.
/// @throws Error  for arrays that do not fit the mesh.
GltfVertices vertices_of(const GltfDocument& document, const Accessors& accessors,
                         const JsonPlace& primitive, const std::vector<std::uint64_t>& uv_sets,
                         const TriangleMesh& mesh);

}  // namespace sunfleck::engine
