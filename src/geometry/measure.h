// Sizes of placed shapes in the world: for the power of lights, and for choosing points on them.
#pragma once

#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "geometry/geometry_input.h"
#include "geometry/triangle.h"

namespace sunfleck::engine {

/// A box around the image of a box; empty for an empty one.
Bounds image_of(const Bounds& box, const Affine& map);

/// Where a vertex of a mesh stands for Geometry: its image, rounded to float.
inline Vec3 placed_vertex(const Vec3& p, const Affine& to_world) {
    return {to_world.point(Vec3d(p))};
}

/// The corners of one triangle of a placed mesh, as Geometry has them.
Triangle placed_triangle(const TriangleMesh& mesh, const Affine& to_world, std::size_t triangle);

/// The area of one side in the world, in squares of the scene's unit. Triangles are summed in
/// double, in order; spheres by a closed form under rotations, mirrors and uniform scales, else by
/// quadrature to 1e-6, and so are cylinders and bilinear patches; disks exactly. Not finite or out
/// of range triangles and patches count nothing. Curves have none: flat ones turn with the ray.
double surface_area(const PlacedShape& placed);

/// A box around the shape, in the frame that its matrix leads to. Of a mesh it is the box around
/// the turned box of the vertices that are used.
Bounds bounds_of(const PlacedShape& placed);

}  // namespace sunfleck::engine
