// Polygons, unused vertices, and remarks.
#include "import/ply/body.h"

#include "import/ply/polygons.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

std::vector<Vec3d> corners_of(const PlyFan& fan, const PlyBody& body) {
    std::vector<Vec3d> corners;
    const auto add = [&](std::size_t triangle, std::size_t corner) {
        corners.push_back(body.mesh.positions[body.mesh.triangles[triangle].at(corner)]);
    };
    add(fan.first, 0);
    add(fan.first, 1);
    for (std::size_t i = 0; i + 2 < fan.corners; ++i) add(fan.first + i, 2);
    return corners;
}

void check_fans(const PlyBody& body, const std::string& name) {
    for (const PlyFan& fan : body.fans)
        if (!is_planar_and_convex(corners_of(fan, body)))
            throw Error({name},
                        "face " + std::to_string(fan.face) + ": it has " +
                            std::to_string(fan.corners) + " corners that are not planar and convex",
                        "triangulate the mesh");
}

void check_broken(const PlyBody& body, const std::string& name) {
    std::vector<bool> is_used(body.mesh.positions.size());
    for (const auto& triangle : body.mesh.triangles)
        for (const std::uint32_t corner : triangle) is_used[corner] = true;
    for (const std::uint64_t vertex : body.broken)
        if (is_used[vertex])
            throw Error(
                {name},
                "vertex " + std::to_string(vertex) + ": a number that is not finite, or too large",
                "export the mesh again without it");
}

/// Removes broken vertices, which no triangle uses.
void remove_broken(PlyBody& body) {
    PlyMesh& mesh = body.mesh;
    std::vector<std::uint32_t> moved(mesh.positions.size());
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (std::binary_search(body.broken.begin(), body.broken.end(), i)) continue;
        moved[i] = kept;
        mesh.positions[kept] = mesh.positions[i];
        if (!mesh.normals.empty()) mesh.normals[kept] = mesh.normals[i];
        if (!mesh.uvs.empty()) mesh.uvs[kept] = mesh.uvs[i];
        if (!mesh.colours.empty()) mesh.colours[kept] = mesh.colours[i];
        ++kept;
    }
    mesh.positions.resize(kept);
    if (!mesh.normals.empty()) mesh.normals.resize(kept);
    if (!mesh.uvs.empty()) mesh.uvs.resize(kept);
    if (!mesh.colours.empty()) mesh.colours.resize(kept);
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) corner = moved[corner];
}

}  // namespace

PlyMesh finished_ply(PlyBody body, const std::string& name) {
    if (body.mesh.triangles.empty())
        throw Error({name}, "no face has three corners", "export a triangle mesh");
    if (!body.broken.empty()) check_broken(body, name);
    check_fans(body, name);
    const auto remark = [&](std::size_t count, const std::string& what) {
        if (count > 0) body.mesh.remarks.push_back(what + " (" + std::to_string(count) + ")");
    };
    remark(body.fans.size(), "faces of more than four corners were triangulated");
    remark(body.faces_left_out, "faces of fewer than three corners were left out");
    remark(body.broken_uvs, "texture coordinates that are not finite became (0, 0)");
    if (body.has_face_uvs)
        body.mesh.remarks.emplace_back(
            "texture coordinates of faces (texcoord) are not read: give each vertex its own");
    remark(body.broken.size(), "unused vertices that are not finite were left out");
    if (!body.broken.empty()) remove_broken(body);
    return std::move(body.mesh);
}

}  // namespace sunfleck::engine
