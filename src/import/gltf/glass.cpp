// The surface of all primitives together, with welded vertices.
#include "import/gltf/glass.h"

#include "geometry/weld.h"

#include <array>
#include <cstdint>

namespace sunfleck::engine {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Adds the triangles of a mesh by the welder's numbers.
void add_welded(const TriangleMesh& mesh, Welder& welder, Triangles& triangles) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions) numbers.push_back(welder.number_of(p));
    for (const auto& t : mesh.triangles)
        triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
}

bool has_no_area(const std::array<std::uint32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}  // namespace

std::vector<SurfaceSides> sides_of_primitives(const std::vector<const TriangleMesh*>& meshes) {
    Welder welder;
    Triangles triangles;
    for (const TriangleMesh* mesh : meshes) add_welded(*mesh, welder, triangles);
    const SurfaceSides all = sides_of(welder.positions(), triangles);
    std::vector<SurfaceSides> sides;
    std::size_t t = 0;
    for (const TriangleMesh* mesh : meshes) {
        SurfaceSides& of_mesh = sides.emplace_back();
        for (std::size_t i = 0; i < mesh->triangles.size(); ++i, ++t) {
            // One without area, as at the pole of a sphere, makes no pane.
            of_mesh.is_closed.push_back(all.is_closed[t] || has_no_area(triangles[t]));
            of_mesh.is_reversed.push_back(all.is_reversed[t]);
        }
    }
    return sides;
}

void turn_triangles(TriangleMesh& mesh, const std::vector<bool>& reversed) {
    std::vector<bool> is_turned(mesh.normals.size(), false);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!reversed[i]) continue;
        auto& t = mesh.triangles[i];
        std::swap(t[1], t[2]);
        for (const std::uint32_t vertex : t) {
            if (mesh.normals.empty() || is_turned[vertex]) continue;
            mesh.normals[vertex] = -mesh.normals[vertex];
            is_turned[vertex] = true;
        }
    }
}

TriangleMesh chosen_triangles(const TriangleMesh& mesh, const std::vector<bool>& chosen) {
    TriangleMesh part = mesh;
    part.triangles.clear();
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) part.triangles.push_back(mesh.triangles[i]);
    return part;
}

}  // namespace sunfleck::engine
