// Meshes from parameters, every count and index checked.
#include "import/pbrt/meshes.h"

#include "import/pbrt/ply.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

namespace sunfleck {
namespace {

std::vector<Vec3> triples(const Parameter* parameter) {
    std::vector<Vec3> result;
    if (!parameter) return result;
    const auto& v = parameter->numbers;
    result.reserve(v.size() / 3);
    for (std::size_t i = 0; i + 2 < v.size(); i += 3)
        result.emplace_back(static_cast<float>(v[i]), static_cast<float>(v[i + 1]),
                            static_cast<float>(v[i + 2]));
    return result;
}

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

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Statement& statement,
                                                       std::size_t vertices) {
    const Parameter* indices = statement.find("indices", ParameterType::integer);
    if (!indices || indices->integers.empty()) {
        if (vertices == 3) return {{0, 1, 2}};
        throw Error(statement.where,
                    "a trianglemesh of " + std::to_string(vertices) + " vertices without indices",
                    "add \"integer indices\"");
    }
    const std::size_t count = indices->integers.size();
    if (count % 3 != 0)
        throw Error(indices->where, std::to_string(count) + " indices make no whole triangles",
                    "give a multiple of 3");
    std::vector<std::array<std::uint32_t, 3>> result(count / 3);
    for (std::size_t i = 0; i < count; ++i)
        result[i / 3][i % 3] = checked_index(*indices, i, vertices);
    return result;
}

}  // namespace

TriangleMesh triangle_mesh(const Statement& statement) {
    TriangleMesh mesh;
    mesh.positions = triples(statement.find("P", ParameterType::point3));
    if (mesh.positions.empty())
        throw Error(statement.where, "a trianglemesh without vertices", "add \"point3 P\"");
    const std::size_t vertices = mesh.positions.size();
    mesh.triangles = triangles_of(statement, vertices);
    const Parameter* normals = statement.find("N", ParameterType::normal);
    mesh.normals = triples(normals);
    check_count(normals, mesh.normals.size(), vertices);
    const Parameter* uvs = statement.find("uv", ParameterType::point2);
    mesh.uvs = pairs(uvs);
    check_count(uvs, mesh.uvs.size(), vertices);
    const Parameter* tangents = statement.find("S", ParameterType::vector3);
    mesh.tangents = triples(tangents);
    check_count(tangents, mesh.tangents.size(), vertices);
    statement.ignore({"faceIndices"});
    return mesh;
}

TriangleMesh ply_mesh(const Statement& statement, Reading& reading) {
    const auto name = statement.text("filename");
    if (!name) throw Error(statement.where, "a plymesh without a file", "add \"string filename\"");
    if (statement.find("displacement"))
        reading.warn(statement.where, "displacement is not simulated: meshes stay as they are");
    statement.ignore({"edgelength"});
    return parse_ply(reading.read_file(*name, statement.where), resolved(*name, reading.folder));
}

}  // namespace sunfleck
