// PLY files: reads triangle meshes with normals and texture coordinates.
//
// In:  ASCII or binary, of either byte order, plain or packed by gzip. Out: a PlyMesh.
// Source: Turk, The PLY Polygon File Format (1994); names of properties as in pbrt-v4.
#pragma once

#include "import/ply/mesh.h"
#include "sunfleck/error.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Reads x y z, and where present nx ny nz and one pair of u v, s t, texture_u texture_v,
/// texture_s texture_t of "vertex"; vertex_indices (or vertex_index) of "face". A quad becomes the
/// triangles 0 1 2 and 0 2 3. Planar convex faces of more corners are cut likewise; faces of fewer
/// than three corners and vertices that are no finite numbers and belong to no face are left out,
/// texture coordinates that are not finite become (0, 0), all with a remark. Everything else in the
/// file is skipped.
/// @param name  of the file, for errors.
/// @throws Error with line and column for faults of the header; with the element and its number
///         (from 0) for faults of the body: cut files, counts that the file cannot hold, numbers
///         that are not finite floats, indices that name no vertex, other faces of more than four
///         corners. For what is no PLY file, it says what the file is.
PlyMesh parse_ply(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
