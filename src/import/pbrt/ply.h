// PLY files: triangle meshes with normals and texture coordinates, as pbrt-v4 reads them.
//
// In:  ASCII or binary, of either byte order, plain or packed by gzip. Out: a TriangleMesh.
// Source: Turk, The PLY Polygon File Format (1994); names of properties as in pbrt-v4.
#pragma once

#include "core/error.h"
#include "geometry/triangle_mesh.h"

#include <string>
#include <string_view>

namespace sunfleck {

struct PlyFile {
    TriangleMesh mesh;
    Vec3d origin{0};  // that its positions are relative to; zero, unless they are far from it
};

/// Reads the file.
/// @param from  the statement that asks for it: the place of the error if it cannot be opened.
/// @throws Error as parse_ply() does.
PlyFile read_ply(const std::string& path, const SourceLocation& from);

/// Reads x y z, and where present nx ny nz and one pair of u v, s t, texture_u texture_v,
/// texture_s texture_t of "vertex"; vertex_indices (or vertex_index) of "face". A quad becomes the
/// triangles 0 1 2 and 0 2 3. Everything else in the file is skipped.
/// @param name  of the file, for errors.
/// @throws Error with line and column for faults of the header; with the element and its number
///         (from 0) for faults of the body: cut files, counts that the file cannot hold, numbers
///         that are not finite floats, indices that name no vertex, faces of other than 3 or 4.
PlyFile parse_ply(std::string_view bytes, const std::string& name);

}  // namespace sunfleck
