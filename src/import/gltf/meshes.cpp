// Triangles from lists, strips and fans, morphed and skinned.
#include "import/gltf/meshes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

enum class Topology { list = 4, strip = 5, fan = 6 };

/// Adds the triangles of a list, a strip or a fan.
void assemble(const std::vector<std::uint32_t>& corners, Topology topology, Triangles& triangles) {
    if (topology == Topology::list) {
        triangles.reserve(corners.size() / 3);
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
        return;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        if (topology == Topology::fan)
            triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
        else  // every other triangle of a strip is turned
            triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    }
}

/// Adds morph targets to an attribute.
void morph(const Accessors& accessors, const JsonPlace& primitive, const MeshPose& pose,
           std::string_view attribute, std::vector<Vec3>& values) {
    const std::vector<JsonPlace> targets = primitive.elements("targets");
    for (std::size_t t = 0; t < std::min(targets.size(), pose.weights.size()); ++t) {
        const auto moved = targets[t].find(attribute);
        if (!moved || pose.weights[t] == 0) continue;
        const std::vector<Vec3> by = accessors.triples(*moved);
        if (by.size() != values.size())
            moved->refuse("has another number of vertices than the mesh", "export the file again");
        for (std::size_t i = 0; i < by.size(); ++i)
            values[i] += by[i] * static_cast<float>(pose.weights[t]);
    }
}

/// The joints that move each vertex: sets of four.
struct Influences {
    std::vector<std::array<std::uint32_t, 4>> joints;
    std::vector<std::array<float, 4>> weights;
};

std::vector<Influences> influences_of(const Accessors& accessors, const JsonPlace& attributes,
                                      std::size_t vertices) {
    std::vector<Influences> sets;
    for (int set = 0;; ++set) {
        const auto joints = attributes.find("JOINTS_" + std::to_string(set));
        const auto weights = attributes.find("WEIGHTS_" + std::to_string(set));
        if (!joints || !weights) return sets;
        sets.push_back({accessors.index_quadruples(*joints), accessors.quadruples(*weights)});
        if (sets.back().joints.size() != vertices || sets.back().weights.size() != vertices)
            joints->refuse("has another number of vertices than the mesh", "export the file again");
    }
}

/// Moves vertices with their joints, into the world.
void skin(const Accessors& accessors, const JsonPlace& attributes, const MeshPose& pose,
          TriangleMesh& mesh) {
    const std::vector<Influences> sets =
        influences_of(accessors, attributes, mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        Matrix frame(0.0);
        double total = 0;
        for (const Influences& set : sets)
            for (std::size_t k = 0; k < 4; ++k) {
                const auto weight = static_cast<double>(set.weights[v].at(k));
                if (weight == 0) continue;
                if (set.joints[v].at(k) >= pose.joints.size())
                    attributes.refuse("name a joint that the skin lacks", "export the file again");
                frame += pose.joints[set.joints[v].at(k)] * weight;
                total += weight;
            }
        if (!(total > 0)) continue;
        frame *= 1 / total;
        mesh.positions[v] = Vec3(Vec3d(mesh.positions[v]) * frame);
        if (mesh.normals.empty()) continue;
        Vec3d normal;
        frame.inverse().transposed().multDirMatrix(Vec3d(mesh.normals[v]), normal);
        mesh.normals[v] = Vec3(normal.normalized());
    }
}

void check_size(const JsonPlace& attribute, std::size_t size, std::size_t vertices) {
    if (size != vertices)
        attribute.refuse(
            "has " + std::to_string(size) + " vertices, POSITION " + std::to_string(vertices),
            "export the file again");
}

/// Returns the triangles of a primitive. In strips and fans the largest index that its type can
/// hold begins anew (KHR_mesh_primitive_restart); core glTF has no such index.
Triangles assembled(const Accessors& accessors, const JsonPlace& primitive, std::size_t vertices,
                    Topology topology) {
    Triangles triangles;
    const auto indices = primitive.find("indices");
    std::vector<std::uint32_t> corners;
    if (!indices) {
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), 0U);
        assemble(corners, topology, triangles);
        return triangles;
    }
    const std::uint32_t restart = accessors.largest_index(*indices);
    for (const std::uint32_t corner : accessors.indices(*indices)) {
        if (corner == restart && topology != Topology::list) {
            assemble(corners, topology, triangles);
            corners.clear();
            continue;
        }
        if (corner >= vertices)
            indices->refuse(
                "names vertex " + std::to_string(corner) + " of " + std::to_string(vertices),
                "export the file again");
        corners.push_back(corner);
    }
    assemble(corners, topology, triangles);
    return triangles;
}

std::vector<double> weights_of(const JsonPlace& holder) {
    std::vector<double> weights;
    for (const JsonPlace& weight : holder.elements("weights")) weights.push_back(weight.number());
    return weights;
}

}  // namespace

MeshPose pose_of(const GltfDocument& document, const GltfNodes& nodes, const Accessors& accessors,
                 const GltfNode& node, const JsonPlace& mesh) {
    MeshPose pose;
    pose.weights = node.weights;
    if (pose.weights.empty()) pose.weights = weights_of(node.place);
    if (pose.weights.empty()) pose.weights = weights_of(mesh);
    const auto number = node.place.find("skin");
    if (!number) return pose;
    const auto row = [&](int i) {
        return Vec3d(node.to_world[i][0], node.to_world[i][1], node.to_world[i][2]);
    };
    pose.is_mirrored = row(0).cross(row(1)).dot(row(2)) < 0;
    const JsonPlace skin = document.element("skins", *number);
    std::vector<std::array<float, 16>> bindings;
    if (const auto inverse = skin.find("inverseBindMatrices"))
        bindings = accessors.matrices(*inverse);
    const std::vector<JsonPlace> joints = skin.elements("joints");
    const std::size_t all_nodes = document.count("nodes");
    for (std::size_t j = 0; j < joints.size(); ++j) {
        Matrix binding;
        for (int k = 0; k < 16 && j < bindings.size(); ++k)
            binding[k / 4][k % 4] =
                static_cast<double>(bindings[j].at(static_cast<std::size_t>(k)));
        pose.joints.push_back(binding * nodes.to_world(joints[j].index(all_nodes, "node")));
    }
    return pose;
}

std::optional<TriangleMesh> triangles_of(const Accessors& accessors, const JsonPlace& primitive,
                                         const MeshPose& pose, std::uint64_t uv_set,
                                         Warnings& warnings) {
    const std::uint64_t mode = primitive.whole("mode", 4);
    if (mode > 6) primitive.at("mode").refuse("is no topology", "write 0 to 6");
    if (mode < 4) {
        warnings.add(primitive.where(), "points and lines have no surface and are left out");
        return {};
    }
    const JsonPlace attributes = primitive.at("attributes");
    TriangleMesh mesh;
    const auto positions = attributes.find("POSITION");
    if (!positions) return {};
    mesh.positions = accessors.triples(*positions);
    morph(accessors, primitive, pose, "POSITION", mesh.positions);
    const std::size_t vertices = mesh.positions.size();
    if (const auto normals = attributes.find("NORMAL")) {
        mesh.normals = accessors.directions(*normals);
        check_size(*normals, mesh.normals.size(), vertices);
        morph(accessors, primitive, pose, "NORMAL", mesh.normals);
    }
    if (const auto uvs = attributes.find("TEXCOORD_" + std::to_string(uv_set))) {
        mesh.uvs = accessors.pairs(*uvs);
        check_size(*uvs, mesh.uvs.size(), vertices);
        for (Vec2& uv : mesh.uvs) uv.y = 1 - uv.y;
    }
    if (!pose.is_rigid()) skin(accessors, attributes, pose, mesh);
    mesh.triangles = assembled(accessors, primitive, vertices, static_cast<Topology>(mode));
    if (!pose.is_rigid() && pose.is_mirrored)
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    if (mesh.triangles.empty()) return {};
    return mesh;
}

}  // namespace sunfleck::engine
