// Convex bodies as the meeting of half-spaces, and their facets.
//
// Points are rounded to 2^-16 of a unit, so that a corner that several facets compute has the same
// bits in each: facets of bodies that share planes meet without gaps.
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

/// Corners around its edge; counter-clockwise seen from where its normal points to.
using Polygon = std::vector<Vec3d>;

/// The facet that lies in the plane of half-space `index`, of the body in which all of them meet.
/// @param bodies  facets fit into a square of side 200 units around the foot of the origin.
/// @return corners as seen from outside, rounded; empty where the plane misses the body.
Polygon facet(const std::vector<HalfSpace>& half_spaces, std::size_t index);

/// Adds a convex polygon as a fan of triangles.
void add_polygon(Mesh& mesh, const Polygon& polygon);

}  // namespace sunfleck::engine
