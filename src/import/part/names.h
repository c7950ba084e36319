// PartObjects: the objects of a part, by which mattes tell its triangles apart.
#pragma once

#include "import/obj/mesh.h"
#include "scene/description.h"

#include <span>
#include <string>
#include <vector>

namespace sunfleck::engine {

class PartObjects {
public:
    /// @param path  of the part. Its name stands for triangles of no object.
    PartObjects(const ObjMesh& mesh, const std::string& path);

    /// Names a shape. @param triangles  of the mesh, in the order of the shape's.
    void name(ShapeDescription& shape, std::span<const std::uint32_t> triangles) const;

private:
    std::vector<std::string> names_;          // the last is that of no object
    std::vector<std::uint32_t> of_triangle_;  // index into names_; empty where there is one name
};

}  // namespace sunfleck::engine
