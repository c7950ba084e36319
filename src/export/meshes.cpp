// One overload for each shape.
#include "export/meshes.h"

#include "export/coordinates.h"

#include <fmt/format.h>

#include <bit>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kReadableTriangles = 60;
constexpr double kTurn = 2 * kPiDouble;

void append_bytes(std::string& bytes, std::uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(word >> shift)));
}

void append_bytes(std::string& bytes, float value) {
    append_bytes(bytes, std::bit_cast<std::uint32_t>(value));
}

void append_bytes(std::string& bytes, const Vec3& v) {
    for (int i = 0; i < 3; ++i) append_bytes(bytes, v[i]);
}

std::string ply_head(const TriangleMesh& mesh) {
    std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    head += std::to_string(mesh.positions.size());
    head += "\nproperty float x\nproperty float y\nproperty float z\n";
    if (!mesh.normals.empty()) head += "property float nx\nproperty float ny\nproperty float nz\n";
    if (!mesh.uvs.empty()) head += "property float u\nproperty float v\n";
    head += "element face " + std::to_string(mesh.triangles.size());
    return head + "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <std::size_t N>
std::string index_text(const std::vector<std::array<std::uint32_t, N>>& faces) {
    std::string text;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (i > 0) text += i % 6 == 0 ? "\n        " : "  ";
        text += fmt::format("{}", fmt::join(faces[i], " "));
    }
    return text;
}

template <class Mesh>
void add_vertices(StatementText& statement, const Mesh& mesh) {
    statement.add("point3", "P", std::span<const Vec3>(mesh.positions));
    if (!mesh.normals.empty()) statement.add("normal", "N", std::span<const Vec3>(mesh.normals));
    if (!mesh.uvs.empty()) statement.add("point2", "uv", std::span<const Vec2>(mesh.uvs));
}

TriangleMesh mapped(TriangleMesh mesh, const Mapping& mapping) {
    mesh.uvs = mapped_coordinates(mesh, mapping);
    return mesh;
}

StatementText triangle_statement(const TriangleMesh& mesh) {
    StatementText statement("Shape", "trianglemesh");
    add_vertices(statement, mesh);
    if (!mesh.tangents.empty()) statement.add("vector3", "S", std::span<const Vec3>(mesh.tangents));
    statement.add("integer", "indices", index_text(mesh.triangles));
    return statement;
}

StatementText patch_statement(const BilinearMesh& mesh) {
    StatementText statement("Shape", "bilinearmesh");
    add_vertices(statement, mesh);
    statement.add("integer", "indices", index_text(mesh.patches));
    return statement;
}

void add_azimuth(StatementText& statement, double phi_max) {
    if (phi_max < kTurn) statement.add("phimax", phi_max / kTurn * 360);
}

StatementText sphere_statement(const Sphere& sphere) {
    StatementText statement("Shape", "sphere");
    statement.add("radius", sphere.radius);
    if (sphere.z_min > -sphere.radius) statement.add("zmin", sphere.z_min);
    if (sphere.z_max < sphere.radius) statement.add("zmax", sphere.z_max);
    add_azimuth(statement, sphere.phi_max);
    return statement;
}

StatementText disk_statement(const Disk& disk) {
    StatementText statement("Shape", "disk");
    statement.add("height", disk.height);
    statement.add("radius", disk.radius);
    statement.add("innerradius", disk.inner_radius);
    add_azimuth(statement, disk.phi_max);
    return statement;
}

StatementText cylinder_statement(const Cylinder& cylinder) {
    StatementText statement("Shape", "cylinder");
    statement.add("radius", cylinder.radius);
    statement.add("zmin", cylinder.z_min);
    statement.add("zmax", cylinder.z_max);
    add_azimuth(statement, cylinder.phi_max);
    return statement;
}

StatementText curve_statement(const CurveSegment& segment, CurveKind kind) {
    StatementText statement("Shape", "curve");
    statement.add_word("string", "type",
                       kind == CurveKind::flat       ? "flat"
                       : kind == CurveKind::cylinder ? "cylinder"
                                                     : "ribbon");
    statement.add("point3", "P", std::span<const Vec3>(segment.points));
    statement.add("width0", segment.width[0]);
    statement.add("width1", segment.width[1]);
    if (kind == CurveKind::ribbon)
        statement.add("normal", "N", std::span<const Vec3>(segment.normal));
    return statement;
}

}  // namespace

std::string ply_of(const TriangleMesh& mesh) {
    std::string bytes = ply_head(mesh);
    bytes.reserve(bytes.size() + 32 * mesh.positions.size() + 13 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        append_bytes(bytes, mesh.positions[i]);
        if (!mesh.normals.empty()) append_bytes(bytes, mesh.normals[i]);
        if (mesh.uvs.empty()) continue;
        append_bytes(bytes, mesh.uvs[i].x);
        append_bytes(bytes, mesh.uvs[i].y);
    }
    for (const auto& triangle : mesh.triangles) {
        bytes.push_back(3);
        for (const std::uint32_t index : triangle) append_bytes(bytes, index);
    }
    return bytes;
}

/// PLY files of pbrt-v4 have no tangents: meshes with them are written in full.
StatementText ShapeStatements::mesh(const TriangleMesh& mesh, const Mapping* mapping) {
    if (mesh.triangles.size() <= kReadableTriangles || !mesh.tangents.empty())
        return mapping ? triangle_statement(mapped(mesh, *mapping)) : triangle_statement(mesh);
    const std::string name = fmt::format("{}/mesh-{}.ply", folder_, ++meshes_);
    if (mapping)
        files_.push_back({name, [&mesh, by = *mapping] { return ply_of(mapped(mesh, by)); }});
    else
        files_.push_back({name, [&mesh] { return ply_of(mesh); }});
    StatementText statement("Shape", "plymesh");
    statement.add_word("string", "filename", name);
    return statement;
}

std::vector<StatementText> ShapeStatements::of(const Shape& shape, const Mapping* mapping) {
    struct Visitor {
        ShapeStatements& writer;
        const Mapping* mapping;
        using Texts = std::vector<StatementText>;

        Texts operator()(const TriangleMesh& s) const { return {writer.mesh(s, mapping)}; }
        Texts operator()(const BilinearMesh& s) const { return {patch_statement(s)}; }
        Texts operator()(const Sphere& s) const { return {sphere_statement(s)}; }
        Texts operator()(const Disk& s) const { return {disk_statement(s)}; }
        Texts operator()(const Cylinder& s) const { return {cylinder_statement(s)}; }
        Texts operator()(const Curves& s) const {
            Texts texts;
            for (const CurveSegment& segment : s.segments)
                texts.push_back(curve_statement(segment, s.kind));
            return texts;
        }
    };
    return std::visit(Visitor{*this, mapping}, shape);
}

}  // namespace sunfleck::engine
