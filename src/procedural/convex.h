// Convex bodies as intersections of half-spaces, and their facets.
//
// Points are rounded to 2^-16 of a unit, so that a corner that several facets compute has the same
// bits in each: facets of bodies with common planes join without gaps.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

#include <vector>

namespace sunfleck::engine {

/// The points x with dot(normal, x) <= offset.
struct HalfSpace {
    Vec3d normal;
    double offset = 0;
};

/// Corners in order around the edge; counter-clockwise seen from the side of the normal.
using Polygon = std::vector<Vec3d>;

/// Returns the facet of the intersection of all half-spaces that lies in the plane of half-space
/// `index`.
/// @param half_spaces  facets fit into a square of side 200 around the projection of the origin.
/// @return corners as seen from outside, rounded; empty if the plane misses the body.
Polygon facet(const std::vector<HalfSpace>& half_spaces, std::size_t index);

/// Adds a convex polygon as a fan of triangles.
void add_polygon(Mesh& mesh, const Polygon& polygon);

}  // namespace sunfleck::engine
