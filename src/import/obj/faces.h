// ObjFaces: collects the faces of an OBJ file and makes triangles of them.
#pragma once

#include "import/obj/corners.h"
#include "import/obj/mesh.h"

#include <span>
#include <string>

namespace sunfleck::engine {

/// Counts of what was left out or changed.
struct ObjFaceCounts {
    std::size_t small = 0;     // of fewer than three corners
    std::size_t flat = 0;      // triangles with two corners at one vertex
    std::size_t crossing = 0;  // polygons that cross themselves
};

class ObjFaces {
public:
    /// Takes a face as a fan. @param cursor  behind it, for errors.
    void add(std::span<const ObjCorner> corners, const TextCursor& cursor);
    /// Begins a run if material, smoothing or object changed.
    void set_material(std::uint32_t material) { run_.material = material; }
    void set_smoothing(std::uint32_t group) { run_.smoothing = group; }
    void set_object(std::uint32_t object) { run_.object = object; }
    std::size_t triangles() const { return triangles_.size(); }

    /// Moves triangles and runs into the mesh, which has its positions: concave polygons are
    /// triangulated again, and triangles that are none removed.
    ObjFaceCounts finish(ObjMesh& mesh);

private:
    /// A face of more than three corners as a fan of triangles.
    struct Fan {
        std::size_t first = 0;  // its first triangle
        std::uint32_t corners = 0;
    };

    void push(const ObjCorner& a, const ObjCorner& b, const ObjCorner& c);
    void set(std::size_t triangle, const std::array<ObjCorner, 3>& corners);
    std::vector<ObjCorner> corners_of(const Fan& fan) const;
    void triangulate(const Fan& fan, const ObjMesh& mesh);
    void remove_flat(ObjMesh& mesh);

    std::vector<ObjTriangle> triangles_;
    std::array<std::vector<ObjTriangle>, 2> others_;  // of uvs and normals; shorter than triangles_
    std::vector<ObjRun> runs_;
    ObjRun run_;  // in force
    std::vector<Fan> fans_;
    ObjFaceCounts counts_;
};

}  // namespace sunfleck::engine
