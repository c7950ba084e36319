// Reader of PLY files: triangle meshes with normals and texture coordinates.
//
// In:  ASCII or binary of either byte order, plain or gzip. Out: a PlyMesh.
// Source: Turk, The PLY Polygon File Format (1994); names of properties as in pbrt-v4.
#pragma once

#include "import/ply/mesh.h"
#include "sunfleck/error.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Reads x y z of "vertex" and, if present, nx ny nz and one pair of u v, s t, texture_u texture_v,
/// texture_s texture_t; red green blue; vertex_indices (or vertex_index) of "face". A quad becomes
/// the triangles 0 1 2 and 0 2 3, and planar convex faces of more corners become a fan. Each of the
/// following gives a remark: faces of fewer than three corners are left out, unused vertices that
/// are not finite are left out, and texture coordinates that are not finite become (0, 0).
/// Everything else in the file is skipped.
/// @param name  file name for errors.
/// @throws Error  with line and column for faults of the header; with the element and its index
/// (from 0) for faults of the body: truncated files, counts that the file cannot hold, numbers that
/// are not finite floats, invalid vertex indices, other faces of more than four corners. If the
/// file is not PLY, the error names its type.
PlyMesh parse_ply(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
