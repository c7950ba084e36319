// ObjMesh: the polygons of an OBJ file as triangles, with what was in force for each.
#pragma once

#include "math/vector.h"
#include "sunfleck/error.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// In place of an index that is not given.
inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFF;

using ObjTriangle = std::array<std::uint32_t, 3>;

/// A name in a statement.
struct ObjName {
    std::string name;
    SourceLocation where{};
};

/// Triangles from `first` to the next run, with material, smoothing and object in force.
struct ObjRun {
    std::size_t first = 0;
    std::uint32_t material = kNoIndex;  // index into ObjMesh::materials
    std::uint32_t smoothing = 0;        // group; 0 is off
    std::uint32_t object = kNoIndex;    // index into ObjMesh::objects
};

struct ObjMesh {
    std::vector<Vec3d> positions;
    std::vector<Vec2> uvs;                    // finite
    std::vector<Vec3> normals;                // finite, not zero
    std::vector<Vec3> colours;                // per position, or empty; in [0,1], as stored
    std::vector<ObjTriangle> triangles;       // indices of positions
    std::vector<ObjTriangle> uv_corners;      // of uvs, per triangle; kNoIndex without; or empty
    std::vector<ObjTriangle> normal_corners;  // of normals, likewise; all three or none
    std::vector<ObjRun> runs;                 // ascending; none is empty
    std::vector<ObjName> materials;           // of usemtl, each once
    std::vector<std::string> objects;         // of o, or else of g, each once
    std::vector<ObjName> libraries;           // of mtllib: each the rest of its line
    std::vector<std::string> remarks;         // what was left out or changed
};

}  // namespace sunfleck::engine
