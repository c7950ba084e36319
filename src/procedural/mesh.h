// Mesh: a triangle mesh to be written to a file: points, three indices per triangle, rarely
// normals.
//
// Winding: counter-clockwise seen from outside, as in pbrt-v4 (normal = (p1-p0) x (p2-p0)).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct Mesh {
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 3>> normals;  // one per point for smooth shading, or none

    /// Adds a quadrilateral, given by its corners in order, as triangles a b c and a c d.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }

    /// Adds another mesh; both have normals, or neither.
    void append(const Mesh& other);
};

/// Returns a binary little-endian PLY file: float x y z, nx ny nz if there are normals, then lists
/// of uchar count and int indices named vertex_indices, as pbrt-v4 requires.
std::string ply_bytes(const Mesh& mesh);

/// Returns a `Shape "trianglemesh"` statement of pbrt-v4, for small meshes. Coordinates are the
/// shortest decimals that give the same floats.
std::string shape_text(const Mesh& mesh);

/// Returns a horizontal square around the z axis, facing up: two triangles.
Mesh square_mesh(float half_side, float height);

/// Returns a closed box with outward normals: 8 points, 12 triangles. @param low, high  opposite
/// corners.
Mesh box_mesh(const std::array<float, 3>& low, const std::array<float, 3>& high);

}  // namespace sunfleck::engine
