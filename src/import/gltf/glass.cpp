// Components over shared edges, by union and find.
#include "import/gltf/glass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>

namespace sunfleck::engine {
namespace {

/// Sets that are joined two by two.
class Groups {
public:
    explicit Groups(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }
    std::size_t of(std::size_t i) {
        while (parents_[i] != i) {
            parents_[i] = parents_[parents_[i]];
            i = parents_[i];
        }
        return i;
    }
    void join(std::size_t a, std::size_t b) { parents_[of(a)] = of(b); }

private:
    std::vector<std::size_t> parents_;
};

using Corners = std::array<std::size_t, 3>;

/// Returns the triangles of all meshes by vertices that are one where their places are the same.
std::vector<Corners> welded(const std::vector<const TriangleMesh*>& meshes) {
    std::map<std::tuple<float, float, float>, std::size_t> places;
    std::vector<Corners> triangles;
    for (const TriangleMesh* mesh : meshes) {
        std::vector<std::size_t> numbers;
        numbers.reserve(mesh->positions.size());
        for (const Vec3& p : mesh->positions)
            numbers.push_back(places.try_emplace({p.x, p.y, p.z}, places.size()).first->second);
        for (const auto& t : mesh->triangles)
            triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
    }
    return triangles;
}

bool has_no_area(const Corners& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// An edge of a triangle; the same edge of another has the same ends.
struct Edge {
    std::size_t low;
    std::size_t high;
    std::size_t triangle;
};

std::vector<Edge> sorted_edges(const std::vector<Corners>& triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (has_no_area(triangles[t])) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t].at(k), triangles[t].at((k + 1) % 3));
            edges.push_back({low, high, t});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return edges;
}

}  // namespace

std::vector<std::vector<bool>> closed_triangles(const std::vector<const TriangleMesh*>& meshes) {
    const std::vector<Corners> triangles = welded(meshes);
    const std::vector<Edge> edges = sorted_edges(triangles);
    Groups groups(triangles.size());
    std::vector<bool> has_open_edge(triangles.size(), false);
    for (std::size_t begin = 0; begin < edges.size();) {
        std::size_t end = begin + 1;
        while (end < edges.size() && edges[end].low == edges[begin].low &&
               edges[end].high == edges[begin].high)
            groups.join(edges[begin].triangle, edges[end++].triangle);
        if (end - begin != 2) has_open_edge[edges[begin].triangle] = true;
        begin = end;
    }
    std::vector<bool> is_open(triangles.size(), false);  // by the group's first
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (has_open_edge[t]) is_open[groups.of(t)] = true;
    std::vector<std::vector<bool>> closed;
    std::size_t t = 0;
    for (const TriangleMesh* mesh : meshes) {
        closed.emplace_back();
        for (std::size_t i = 0; i < mesh->triangles.size(); ++i, ++t)
            closed.back().push_back(!is_open[groups.of(t)] && !has_no_area(triangles[t]));
    }
    return closed;
}

double mean_chord(const TriangleMesh& mesh) {
    double volume = 0;
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3d a(mesh.positions[t[0]]);
        const Vec3d b(mesh.positions[t[1]]);
        const Vec3d c(mesh.positions[t[2]]);
        volume += a.dot(b.cross(c)) / 6;
        area += (b - a).cross(c - a).length() / 2;
    }
    return area > 0 ? 4 * std::abs(volume) / area : 0;
}

Vec3d absorption_over(double distance, const Vec3d& left) {
    constexpr double kDarkest = 1e-6;
    Vec3d absorption;
    for (int c = 0; c < 3; ++c)
        absorption[c] = -std::log(std::clamp(left[c], kDarkest, 1.0)) / distance;
    return absorption;
}

TriangleMesh chosen_triangles(const TriangleMesh& mesh, const std::vector<bool>& chosen) {
    TriangleMesh part = mesh;
    part.triangles.clear();
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) part.triangles.push_back(mesh.triangles[i]);
    return part;
}

}  // namespace sunfleck::engine
