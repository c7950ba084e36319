// Loop subdivision against what is known of its limit: symmetric solids, planes, splines at the
// border; the side of the normals; meshes that have no limit.
#include "geometry/loop_subdivision.h"

#include "geometry/half_edges.h"
#include "math/vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sunfleck::engine {
namespace {

TriangleMesh tetrahedron() {
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};  // counter-clockwise outside
    return mesh;
}

TriangleMesh octahedron() {
    TriangleMesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return mesh;
}

/// A flat n x n grid of squares, each cut along one diagonal, with its inner vertices shaken.
TriangleMesh grid(std::uint32_t n) {
    TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) mesh.positions.emplace_back(float(i), float(j), 0);
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh.triangles.push_back({a, a + 1, a + n + 2});
            mesh.triangles.push_back({a, a + n + 2, a + n + 1});
        }
    return mesh;
}

double length(const Vec3& v) {
    return Vec3d(v).length();
}

/// Limit of a vertex of a symmetric solid, where the neighbours' mean is m times the vertex:
/// gamma-weighted. Tetrahedron: valence 3, beta 3/16, gamma 1/5, m = -1/3: 2/5 - 3/5/3 = 1/5.
/// Octahedron: valence 4, beta 3/32, gamma 1/8, m = 0: 1/2.
TEST(LoopSubdivision, vertices_of_symmetric_solids_go_to_their_limits) {
    for (int levels = 0; levels < 4; ++levels) {
        const TriangleMesh tetra = loop_subdivided(tetrahedron(), levels);
        const TriangleMesh octa = loop_subdivided(octahedron(), levels);
        EXPECT_EQ(tetra.triangles.size(), 4U << (2 * levels));
        EXPECT_EQ(octa.triangles.size(), 8U << (2 * levels));
        // The first vertices are those of the control mesh: the same limit on every level.
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(length(tetra.positions[i]), std::sqrt(3.0) / 5, 1e-6) << levels;
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_NEAR(length(octa.positions[i]), 0.5, 1e-6) << levels;
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_LT(length(octa.normals[i] + octa.positions[i] * 2), 1e-6);
    }
}

/// Points that stay from level to level keep their limits: all of level 2 are in level 4.
TEST(LoopSubdivision, limits_do_not_depend_on_the_level) {
    TriangleMesh control = grid(4);
    for (std::size_t i = 0; i < control.positions.size(); ++i)
        control.positions[i].z = std::sin(3.0F * static_cast<float>(i * i));
    const TriangleMesh coarse = loop_subdivided(control, 1);
    const TriangleMesh fine = loop_subdivided(control, 3);
    for (std::size_t i = 0; i < coarse.positions.size(); ++i) {
        EXPECT_LT(length(coarse.positions[i] - fine.positions[i]), 1e-5) << i;
        EXPECT_LT(length(coarse.normals[i] - fine.normals[i]), 1e-4) << i;
    }
}

/// Limit normals are those of the surface that fine meshes approach.
TEST(LoopSubdivision, normals_are_those_of_fine_meshes) {
    TriangleMesh control = grid(4);
    for (std::size_t i = 0; i < control.positions.size(); ++i)
        control.positions[i].z = 0.5F * std::sin(2.0F * static_cast<float>(i * i));
    for (const TriangleMesh& mesh : {loop_subdivided(control, 5), loop_subdivided(octahedron(), 5),
                                     loop_subdivided(tetrahedron(), 5)}) {
        std::vector<Vec3d> sums(mesh.positions.size(), Vec3d(0));
        for (const auto& t : mesh.triangles) {
            const Vec3d a(mesh.positions[t[0]]);
            const Vec3d n =
                (Vec3d(mesh.positions[t[1]]) - a).cross(Vec3d(mesh.positions[t[2]]) - a);
            for (const std::uint32_t v : t) sums[v] += n.normalized();
        }
        for (std::size_t i = 0; i < sums.size(); ++i)
            EXPECT_LT(sums[i].normalized().dot(Vec3d(mesh.normals[i])), -0.99) << i;
    }
}

/// The border is the uniform cubic B-spline of the border's vertices, whatever lies inside.
TEST(LoopSubdivision, borders_are_splines) {
    TriangleMesh control = grid(6);
    const TriangleMesh flat = loop_subdivided(control, 2);
    for (std::size_t i = 0; i < 7; ++i) control.positions[i].z = float(i * i % 5);  // side y = 0
    control.positions[24].z = 100;                                                  // inside
    const TriangleMesh mesh = loop_subdivided(control, 2);
    for (std::size_t i = 1; i < 6; ++i) {
        const Vec3 expected = control.positions[i - 1] / 6.0F + control.positions[i] * (2.0F / 3) +
                              control.positions[i + 1] / 6.0F;
        EXPECT_LT(length(mesh.positions[i] - expected), 1e-5) << i;
    }
    // A plane stays one, inner points of a regular grid stay in place.
    for (const Vec3& p : flat.positions) EXPECT_EQ(p.z, 0);
    EXPECT_LT(length(flat.positions[24] - Vec3(3, 3, 0)), 1e-6);
    for (const Vec3& n : flat.normals) EXPECT_LT(length(n - Vec3(0, 0, -1)), 1e-6);
}

TEST(LoopSubdivision, one_triangle_and_unused_vertices) {
    TriangleMesh one;
    one.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.triangles = {{1, 2, 3}};
    const TriangleMesh mesh = loop_subdivided(one, 3);
    EXPECT_EQ(mesh.triangles.size(), 64U);
    EXPECT_EQ(mesh.positions.size(), 45U);
    for (const Vec3& n : mesh.normals) EXPECT_LT(length(n - Vec3(0, 0, -1)), 1e-6);
    EXPECT_TRUE(loop_subdivided(TriangleMesh{}, 2).triangles.empty());
}

TEST(LoopSubdivision, meshes_without_a_limit) {
    EXPECT_EQ(fault_of_control_mesh(tetrahedron()), "");
    EXPECT_EQ(fault_of_control_mesh(grid(3)), "");
    TriangleMesh three = grid(1);
    three.positions.emplace_back(0, 0, 1);
    three.triangles.push_back({0, 3, 4});  // a third one at the diagonal
    EXPECT_NE(fault_of_control_mesh(three), "");
    TriangleMesh turned = grid(1);
    std::swap(turned.triangles[1][0], turned.triangles[1][1]);
    EXPECT_NE(fault_of_control_mesh(turned), "");
    TriangleMesh twice = grid(1);
    twice.triangles[0][1] = twice.triangles[0][0];
    EXPECT_NE(fault_of_control_mesh(twice), "");
    TriangleMesh fans = tetrahedron();  // two that touch in one vertex
    for (const Vec3& p : tetrahedron().positions) fans.positions.push_back(Vec3(2) - p);
    for (const auto& t : tetrahedron().triangles)
        fans.triangles.push_back(
            {t[0] == 0 ? 0 : t[0] + 4, t[2] == 0 ? 0 : t[2] + 4, t[1] == 0 ? 0 : t[1] + 4});
    EXPECT_NE(fault_of_control_mesh(fans), "");
}

}  // namespace
}  // namespace sunfleck::engine
