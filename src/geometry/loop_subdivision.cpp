// Loop's weights: even and odd vertices of a level, limit positions, limit tangents.
#include "geometry/loop_subdivision.h"

#include "geometry/half_edges.h"
#include "geometry/sweep.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

using Triangles = HalfEdges::Triangles;

/// The weight of each neighbour of an inner vertex.
double weight_of_neighbour(std::size_t valence) {
    return valence == 3 ? 3.0 / 16 : 3.0 / (8 * double(valence));
}

Vec3d sum_of(const std::vector<Vec3d>& points, const std::vector<std::uint32_t>& ring) {
    Vec3d sum(0);
    for (const std::uint32_t v : ring) sum += points[v];
    return sum;
}

struct Mesh {
    std::vector<Vec3d> points;
    Triangles triangles;
};

/// A vertex moved towards its neighbours: `border` is the weight of each of the two along the
/// border, `inner` gives that of all around.
template <class Inner>
Vec3d smoothed(const Mesh& mesh, const HalfEdges& edges, std::uint32_t vertex, double border,
               const Inner& inner) {
    std::vector<std::uint32_t> ring;
    edges.ring(vertex, ring);
    const Vec3d& p = mesh.points[vertex];
    if (edges.on_border(vertex))
        return p * (1 - 2 * border) +
               (mesh.points[ring.front()] + mesh.points[ring.back()]) * border;
    const double weight = inner(ring.size());
    return p * (1 - weight * double(ring.size())) + sum_of(mesh.points, ring) * weight;
}

Vec3d middle_of(const Mesh& mesh, const HalfEdges& edges, std::uint32_t edge) {
    const Vec3d ends = mesh.points[edges.from(edge)] + mesh.points[edges.to(edge)];
    const std::uint32_t twin = edges.twin(edge);
    if (twin == HalfEdges::kNoEdge) return ends * 0.5;
    const auto opposite = [&](std::uint32_t e) {
        return mesh.points[edges.from(HalfEdges::previous(e))];
    };
    return ends * 0.375 + (opposite(edge) + opposite(twin)) * 0.125;
}

Mesh subdivided(const Mesh& mesh) {
    const HalfEdges edges(mesh.triangles, mesh.points.size());
    Mesh result;
    result.points.reserve(4 * mesh.points.size());
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
        result.points.push_back(smoothed(mesh, edges, v, 1.0 / 8, weight_of_neighbour));
    std::vector<std::uint32_t> odd(3 * mesh.triangles.size());
    for (std::uint32_t e = 0; e < odd.size(); ++e) {
        const std::uint32_t twin = edges.twin(e);
        if (twin < e) {
            odd[e] = odd[twin];
            continue;
        }
        odd[e] = static_cast<std::uint32_t>(result.points.size());
        result.points.push_back(middle_of(mesh, edges, e));
    }
    result.triangles.reserve(4 * mesh.triangles.size());
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto& corner = mesh.triangles[f];
        const std::array<std::uint32_t, 3> side{odd[3 * f], odd[3 * f + 1], odd[3 * f + 2]};
        result.triangles.push_back({corner[0], side[0], side[2]});
        result.triangles.push_back({side[0], corner[1], side[1]});
        result.triangles.push_back({side[2], side[1], corner[2]});
        result.triangles.push_back(side);
    }
    return result;
}

/// Across the border, inwards. Source: Hoppe et al. 1994, appendix.
Vec3d inwards(const Mesh& mesh, std::uint32_t vertex, const std::vector<std::uint32_t>& ring) {
    const auto at = [&](std::size_t i) { return mesh.points[ring[i]]; };
    const std::size_t last = ring.size() - 1;
    if (last == 1) return at(0) + at(1) - mesh.points[vertex] * 2;
    if (last == 2) return at(1) - mesh.points[vertex];
    if (last == 3) return at(1) * 2 + at(2) * 2 - at(0) - at(3) - mesh.points[vertex] * 2;
    const double angle = kPiDouble / double(last);
    Vec3d sum = (at(0) + at(last)) * -sin_cos(angle).sin;
    for (std::size_t k = 1; k < last; ++k)
        sum += at(k) * ((2 - 2 * sin_cos(angle).cos) * sin_cos(angle * double(k)).sin);
    return sum;
}

/// The normal of the limit surface on the side from which triangles run clockwise.
Vec3d limit_normal(const Mesh& mesh, const HalfEdges& edges, std::uint32_t vertex) {
    std::vector<std::uint32_t> ring;
    edges.ring(vertex, ring);
    if (edges.on_border(vertex)) {
        const Vec3d along = mesh.points[ring.back()] - mesh.points[ring.front()];
        return along.cross(inwards(mesh, vertex, ring));
    }
    Vec3d first(0);
    Vec3d second(0);
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const SinCos turn = sin_cos_2pi(double(k) / double(ring.size()));
        first += mesh.points[ring[k]] * turn.cos;
        second += mesh.points[ring[k]] * turn.sin;
    }
    return second.cross(first);
}

/// Without the vertices that no triangle has; the others keep their order.
Mesh used_part(const TriangleMesh& control) {
    std::vector<std::uint32_t> place(control.positions.size(), HalfEdges::kNoEdge);
    for (const auto& triangle : control.triangles)
        for (const std::uint32_t v : triangle) place[v] = 0;
    Mesh mesh;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] == HalfEdges::kNoEdge) continue;
        place[v] = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.emplace_back(control.positions[v]);
    }
    for (const auto& t : control.triangles)
        mesh.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
    return mesh;
}

}  // namespace

std::string fault_of_control_mesh(const TriangleMesh& mesh) {
    const HalfEdges edges(mesh.triangles, mesh.positions.size());
    if (!edges.is_regular())
        return "an edge is not that of two triangles that run along it in opposite directions, or "
               "of one";
    std::vector<std::size_t> fans(mesh.positions.size(), 0);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) ++fans[v];
    std::vector<std::uint32_t> ring;
    for (std::uint32_t v = 0; v < fans.size(); ++v) {
        if (fans[v] == 0) continue;
        edges.ring(v, ring);
        const std::size_t expected = edges.on_border(v) ? fans[v] + 1 : fans[v];
        if (ring.size() != expected)
            return "at vertex " + std::to_string(v) + " triangles meet in more than one fan";
    }
    return {};
}

TriangleMesh loop_subdivided(const TriangleMesh& control, int levels) {
    Mesh mesh = used_part(control);
    for (int level = 0; level < levels; ++level) mesh = subdivided(mesh);
    const HalfEdges edges(mesh.triangles, mesh.points.size());
    TriangleMesh result;
    const auto limit_weight = [](std::size_t valence) {
        return 1 / (double(valence) + 3 / (8 * weight_of_neighbour(valence)));
    };
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
        result.positions.emplace_back(smoothed(mesh, edges, v, 1.0 / 6, limit_weight));
        result.normals.emplace_back(limit_normal(mesh, edges, v).normalized());
    }
    result.triangles = std::move(mesh.triangles);
    return result;
}

}  // namespace sunfleck::engine
