// What a surface must be, seen from its triangles: closed, oriented, of a volume, hit by rays.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace sunfleck::engine {

inline Vec3d corner(const Mesh& mesh, std::uint32_t index) {
    const auto& p = mesh.points.at(index);
    return {p[0], p[1], p[2]};
}

/// How often each directed edge occurs, points being compared by their coordinates.
using EdgeCounts = std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int>;

/// @param reversed  counts the mesh as if it were wound the other way.
inline void count_edges(EdgeCounts& counts, const Mesh& mesh, bool reversed = false) {
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            auto edge = std::pair(mesh.points.at(t[i]), mesh.points.at(t[(i + 1) % 3]));
            if (reversed) std::swap(edge.first, edge.second);
            ++counts[edge];
        }
}

/// Edges that do not occur once in each direction: none in a closed, oriented surface.
inline EdgeCounts open_edges(const EdgeCounts& counts) {
    EdgeCounts open;
    for (const auto& [edge, count] : counts) {
        const auto back = counts.find({edge.second, edge.first});
        if (count != 1 || back == counts.end() || back->second != 1) open[edge] = count;
    }
    return open;
}

inline EdgeCounts open_edges(const Mesh& mesh) {
    EdgeCounts counts;
    count_edges(counts, mesh);
    return open_edges(counts);
}

/// Positive when the normals of a closed mesh point outwards.
inline double volume(const Mesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles)
        sum += corner(mesh, t[0]).dot(corner(mesh, t[1]).cross(corner(mesh, t[2]))) / 6;
    return sum;
}

inline Vec3d area_vector(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const Vec3d a = corner(mesh, t[0]);
    return (corner(mesh, t[1]) - a).cross(corner(mesh, t[2]) - a) * 0.5;
}

struct MeshHit {
    double distance = 0;
    bool from_front = false;  // the ray comes from the side that the normal points to
};

/// Where a ray meets a triangle, by Cramer's rule.
inline std::optional<MeshHit> hit(const Mesh& mesh, const std::array<std::uint32_t, 3>& t,
                                  const Vec3d& origin, const Vec3d& direction) {
    const Vec3d a = corner(mesh, t[0]);
    const Vec3d ab = corner(mesh, t[1]) - a;
    const Vec3d ac = corner(mesh, t[2]) - a;
    const double determinant = -direction.dot(ab.cross(ac));
    if (determinant == 0) return {};
    const Vec3d moment = (origin - a).cross(direction);
    const double u = ac.dot(moment) / determinant;
    const double v = -ab.dot(moment) / determinant;
    const double distance = (origin - a).dot(ab.cross(ac)) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || distance <= 0) return {};
    return MeshHit{distance, determinant > 0};
}

inline std::vector<MeshHit> all_hits(const Mesh& mesh, const Vec3d& origin,
                                     const Vec3d& direction) {
    std::vector<MeshHit> hits;
    for (const auto& t : mesh.triangles)
        if (const auto found = hit(mesh, t, origin, direction)) hits.push_back(*found);
    return hits;
}

}  // namespace sunfleck::engine
