// Meshes as binary PLY, and shapes as pbrt-v4 statements.
#pragma once

#include "export/exported_scene.h"
#include "export/statement_text.h"
#include "geometry/shape.h"
#include "texture/mapping.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns a binary little-endian PLY file: positions, normals, u and v, triangles.
std::string ply_of(const TriangleMesh& mesh);

/// Writes shapes; large meshes become files.
class ShapeStatements {
public:
    /// @param folder  of the files, without the last '/'. @param files  receives them.
    ShapeStatements(std::string folder, std::vector<ExportedFile>& files)
        : folder_(std::move(folder)), files_(files) {}

    /// Returns the statements of a shape: of curves one each, of others one alone. The shape must
    /// outlive the files.
    /// @param mapping  of texture coordinates, which a mesh is to have in its own; or null.
    std::vector<StatementText> of(const Shape& shape, const Mapping* mapping = nullptr);

private:
    StatementText mesh(const TriangleMesh& mesh, const Mapping* mapping);

    std::string folder_;
    std::vector<ExportedFile>& files_;
    int meshes_ = 0;
};

}  // namespace sunfleck::engine
