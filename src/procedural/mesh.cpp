// Meshes as bytes: binary PLY and pbrt-v4's trianglemesh; the box.

#include "procedural/mesh.h"

#include "procedural/little_endian.h"

#include <bit>
#include <charconv>
#include <cstddef>

namespace sunfleck::engine {
namespace {

std::string shortest(float value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

std::string triples_text(const std::vector<std::array<float, 3>>& triples) {
    std::string text;
    for (const auto& p : triples)
        text += "\n        " + shortest(p[0]) + ' ' + shortest(p[1]) + ' ' + shortest(p[2]);
    return text + " ]\n";
}

}  // namespace

void Mesh::append(const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    for (const auto& t : other.triangles)
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

std::string ply_bytes(const Mesh& mesh) {
    std::string bytes =
        "ply\n"
        "format binary_little_endian 1.0\n"
        "comment Sunfleck procedural scene, CC0 1.0\n"
        "element vertex " +
        std::to_string(mesh.points.size()) +
        "\n"
        "property float x\n"
        "property float y\n"
        "property float z\n" +
        (mesh.normals.empty() ? "" : "property float nx\nproperty float ny\nproperty float nz\n") +
        "element face " + std::to_string(mesh.triangles.size()) +
        "\n"
        "property list uchar int vertex_indices\n"
        "end_header\n";
    bytes.reserve(bytes.size() + 24 * mesh.points.size() + 13 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        for (const float x : mesh.points[i]) append_float(bytes, x);
        if (!mesh.normals.empty())
            for (const float x : mesh.normals[i]) append_float(bytes, x);
    }
    for (const auto& triangle : mesh.triangles) {
        bytes.push_back(3);
        for (const std::uint32_t index : triangle) append_word(bytes, index);
    }
    return bytes;
}

std::string shape_text(const Mesh& mesh) {
    std::string text = "Shape \"trianglemesh\"\n    \"point3 P\" [" + triples_text(mesh.points);
    if (!mesh.normals.empty()) text += "    \"normal N\" [" + triples_text(mesh.normals);
    text += "    \"integer indices\" [";
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        text += i % 4 == 0 ? "\n        " : "   ";
        text += std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]);
    }
    return text + " ]\n";
}

Mesh square_mesh(float half_side, float height) {
    Mesh mesh;
    mesh.points = {{-half_side, -half_side, height},
                   {half_side, -half_side, height},
                   {half_side, half_side, height},
                   {-half_side, half_side, height}};
    mesh.add_quad(0, 1, 2, 3);
    return mesh;
}

Mesh box_mesh(const std::array<float, 3>& low, const std::array<float, 3>& high) {
    Mesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner)
        mesh.points.push_back({(corner & 1U) != 0 ? high[0] : low[0],
                               (corner & 2U) != 0 ? high[1] : low[1],
                               (corner & 4U) != 0 ? high[2] : low[2]});
    mesh.add_quad(0, 2, 3, 1);  // -z
    mesh.add_quad(4, 5, 7, 6);  // +z
    mesh.add_quad(0, 1, 5, 4);  // -y
    mesh.add_quad(2, 6, 7, 3);  // +y
    mesh.add_quad(0, 4, 6, 2);  // -x
    mesh.add_quad(1, 3, 7, 5);  // +x
    return mesh;
}

}  // namespace sunfleck::engine
