// A triangle mesh on its way into a file: points, three indices a triangle, seldom normals.
//
// Winding: counter-clockwise seen from outside, as pbrt-v4 has it (normal = (p1-p0) x (p2-p0)).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct Mesh {
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 3>> normals;  // one a point for smooth shading, or none at all

    /// Adds the triangles a b c and a c d: a quadrilateral, given around its edge.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }

    /// Adds another mesh; both have normals, or neither has.
    void append(const Mesh& other);
};

/// The mesh as a binary little-endian PLY file: float x y z, nx ny nz where
/// there are normals, then lists of uchar count and int
/// indices, called vertex_indices as pbrt-v4 wants it.
std::string ply_bytes(const Mesh& mesh);

/// The mesh as a `Shape "trianglemesh"` statement of pbrt-v4, for meshes small enough to read.
/// Coordinates are the shortest decimals that read back as the same floats.
std::string shape_text(const Mesh& mesh);

/// A horizontal square around the z axis, facing up: two triangles.
Mesh square_mesh(float half_side, float height);

/// A closed box with outward normals: 8 points, 12 triangles. @param low, high  opposite corners.
Mesh box_mesh(const std::array<float, 3>& low, const std::array<float, 3>& high);

}  // namespace sunfleck::engine
