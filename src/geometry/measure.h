// Areas and bounds of placed shapes, for the power of lights and for sampling points on them.
#pragma once

#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "geometry/geometry_input.h"
#include "geometry/triangle.h"

namespace sunfleck::engine {

/// Returns a box around the image of a box; empty for an empty one.
Bounds image_of(const Bounds& box, const Affine& map);

/// Returns the vertex position that Geometry uses: the image, rounded to float.
inline Vec3 placed_vertex(const Vec3& p, const Affine& to_world) {
    return {to_world.point(Vec3d(p))};
}

/// Returns one triangle of a placed mesh, with the corners that Geometry uses.
Triangle placed_triangle(const TriangleMesh& mesh, const Affine& to_world, std::size_t triangle);

/// Returns the area of one side in the world, in squared scene units. Triangles are summed in
/// double, in order. Disks are exact. Spheres use a closed form under rotations, mirrors and
/// uniform scales, else quadrature to 1e-6, like cylinders and bilinear patches. Triangles and
/// patches that are not finite or out of range count zero. Curves have no area, because flat ones
/// turn to face the ray.
double surface_area(const PlacedShape& placed);

/// Returns a box around the shape in the frame of its matrix; for a mesh, around the transformed
/// box of the used vertices.
Bounds bounds_of(const PlacedShape& placed);

}  // namespace sunfleck::engine
