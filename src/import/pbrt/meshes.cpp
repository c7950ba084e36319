// Meshes from parameters, every count and index checked.
#include "import/pbrt/meshes.h"

#include "geometry/loop_subdivision.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"
#include "import/ply/reader.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

std::vector<Vec2> pairs(const Parameter* parameter) {
    std::vector<Vec2> result;
    if (!parameter) return result;
    const auto& v = parameter->numbers;
    result.reserve(v.size() / 2);
    for (std::size_t i = 0; i + 1 < v.size(); i += 2)
        result.emplace_back(static_cast<float>(v[i]), static_cast<float>(v[i + 1]));
    return result;
}

/// One value a vertex, or none at all.
void check_count(const Parameter* parameter, std::size_t count, std::size_t vertices) {
    if (!parameter || count == vertices) return;
    throw Error(parameter->where,
                "parameter " + parameter->title() + " has " + std::to_string(count) +
                    " values for " + std::to_string(vertices) + " vertices",
                "give one a vertex");
}

std::uint32_t checked_index(const Parameter& indices, std::size_t i, std::size_t vertices) {
    const int index = indices.integers[i];
    if (index >= 0 && static_cast<std::size_t>(index) < vertices)
        return static_cast<std::uint32_t>(index);
    throw Error(indices.where,
                "index " + std::to_string(index) + " at place " + std::to_string(i) +
                    " is that of no vertex",
                "there are " + std::to_string(vertices) + ", counted from 0");
}

/// "indices" by N; one list of all vertices if there are just N and no list.
template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> corners_of(const Statement& statement,
                                                     std::size_t vertices,
                                                     const std::string& what) {
    const Parameter* indices = statement.find("indices", ParameterType::integer);
    std::vector<std::array<std::uint32_t, N>> result;
    if (!indices || indices->integers.empty()) {
        if (vertices != N)
            throw Error(statement.where,
                        "a " + statement.type + " of " + std::to_string(vertices) +
                            " vertices without indices",
                        "add \"integer indices\"");
        auto& only = result.emplace_back();
        for (std::uint32_t i = 0; i < N; ++i) only[i] = i;
        return result;
    }
    const std::size_t count = indices->integers.size();
    if (count % N != 0)
        throw Error(indices->where, std::to_string(count) + " indices make no whole " + what,
                    "give a multiple of " + std::to_string(N));
    result.resize(count / N);
    for (std::size_t i = 0; i < count; ++i)
        result[i / N][i % N] = checked_index(*indices, i, vertices);
    return result;
}

std::vector<Vec3d> positions_of(const Statement& statement) {
    std::vector<Vec3d> positions = triples(statement.find("P", ParameterType::point3));
    if (!positions.empty()) return positions;
    throw Error(statement.where, "a " + statement.type + " without vertices", "add \"point3 P\"");
}

/// "N" and "uv", one a vertex.
template <class Mesh>
void read_attributes(const Statement& statement, Mesh& mesh) {
    const Parameter* normals = statement.find("N", ParameterType::normal);
    mesh.normals = float_triples(normals);
    check_count(normals, mesh.normals.size(), mesh.positions.size());
    const Parameter* uvs = statement.find("uv", ParameterType::point2);
    mesh.uvs = pairs(uvs);
    check_count(uvs, mesh.uvs.size(), mesh.positions.size());
    statement.ignore({"faceIndices"});
}

/// Sets the mesh's positions; warns where the file has too few digits. @return their origin.
Vec3d place_triangles(TriangleMesh& mesh, const std::vector<Vec3d>& positions,
                      const Statement& statement, Reading& reading) {
    LocalPoints local = local_points(positions, all_corners(mesh.triangles));
    const std::string fault = coarseness_of(local, mesh.triangles);
    if (!fault.empty()) reading.log.warn(statement.where, fault);
    mesh.positions = std::move(local.points);
    return local.origin;
}

/// Normals that are no numbers become zero: none. @return how many.
std::size_t drop_broken_normals(TriangleMesh& mesh) {
    std::size_t count = 0;
    for (Vec3& normal : mesh.normals) {
        if (std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z)) continue;
        normal = Vec3(0);
        ++count;
    }
    return count;
}

}  // namespace

std::vector<Vec3d> triples(const Parameter* parameter) {
    std::vector<Vec3d> result;
    if (!parameter) return result;
    const auto& v = parameter->numbers;
    result.reserve(v.size() / 3);
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) result.emplace_back(v[i], v[i + 1], v[i + 2]);
    return result;
}

std::vector<Vec3> float_triples(const Parameter* parameter) {
    const std::vector<Vec3d> exact = triples(parameter);
    return {exact.begin(), exact.end()};
}

LocalShape triangle_mesh(const Statement& statement, Reading& reading) {
    TriangleMesh mesh;
    const std::vector<Vec3d> positions = positions_of(statement);
    mesh.triangles = corners_of<3>(statement, positions.size(), "triangles");
    const Vec3d origin = place_triangles(mesh, positions, statement, reading);
    read_attributes(statement, mesh);
    const Parameter* tangents = statement.find("S", ParameterType::vector3);
    mesh.tangents = float_triples(tangents);
    check_count(tangents, mesh.tangents.size(), mesh.positions.size());
    return {std::move(mesh), origin};
}

/// In pbrt-v4 "emissionfilename" only says where to look for light: the picture is the area
/// light's.
LocalShape bilinear_mesh(const Statement& statement) {
    BilinearMesh mesh;
    const std::vector<Vec3d> positions = positions_of(statement);
    mesh.patches = corners_of<4>(statement, positions.size(), "patches");
    LocalPoints local = local_points(positions, all_corners(mesh.patches));
    mesh.positions = std::move(local.points);
    read_attributes(statement, mesh);
    statement.ignore({"emissionfilename"});
    return {std::move(mesh), local.origin};
}

LocalShape loop_mesh(const Statement& statement, Reading& reading) {
    TriangleMesh control;
    const std::vector<Vec3d> positions = positions_of(statement);
    control.triangles = corners_of<3>(statement, positions.size(), "triangles");
    const Vec3d origin = place_triangles(control, positions, statement, reading);
    const int levels = statement.integer("levels").value_or(3);
    statement.ignore({"scheme"});
    constexpr double kMostTriangles = 3e7;
    const double triangles = std::ldexp(double(control.triangles.size()), 2 * levels);
    if (levels < 0 || !(triangles <= kMostTriangles)) {
        const Parameter* found = statement.find("levels");
        throw Error(found ? found->where : statement.where,
                    levels < 0 ? "a negative number of levels"
                               : "subdivision into more than 30 million triangles",
                    "use 3 levels, for example");
    }
    const std::string fault = fault_of_control_mesh(control);
    if (!fault.empty())
        throw Error(statement.where, "a mesh that cannot be subdivided: " + fault,
                    "repair it, or use a trianglemesh");
    return {loop_subdivided(control, levels), origin};
}

LocalShape ply_mesh(const Statement& statement, Reading& reading) {
    const auto name = statement.text("filename");
    if (!name) throw Error(statement.where, "a plymesh without a file", "add \"string filename\"");
    if (statement.find("displacement"))
        reading.log.warn(statement.where, "displacement is not simulated: meshes stay as they are");
    statement.ignore({"edgelength"});
    PlyMesh ply = reading.assets.files.read_as(*name, statement.where, [](const NamedFile& file) {
        return parse_ply(file.bytes, file.path);
    });
    for (const std::string& remark : ply.remarks)
        reading.log.warn(statement.where, in_quotes(*name) + ": " + remark);
    TriangleMesh mesh;
    mesh.triangles = std::move(ply.triangles);
    mesh.normals = std::move(ply.normals);
    mesh.uvs = std::move(ply.uvs);
    const Vec3d origin = place_triangles(mesh, ply.positions, statement, reading);
    const std::size_t broken = drop_broken_normals(mesh);
    if (broken > 0)
        reading.log.warn(statement.where, std::to_string(broken) + " normals in " +
                                              in_quotes(*name) +
                                              " are no numbers: triangles are flat there");
    return {std::move(mesh), origin};
}

}  // namespace sunfleck::engine
