// Smooth closed surfaces as fine grids, with the topology of a torus or a sphere.
//
// A surface is a function of two numbers in [0, 1). Normals point outwards if its derivative by the
// first, crossed with that by the second, does.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

#include <functional>
#include <vector>

namespace sunfleck::engine {

using SurfacePoint = std::function<Vec3d(double, double)>;

/// Returns a grid closed in both directions. @return 2 * along * around triangles.
Mesh ring_grid(std::size_t along, std::size_t around, const SurfacePoint& point);

/// Returns a grid with the topology of a sphere: point(azimuth, height) with azimuth in [0, 1)
/// about the axis, and height from 0 (one pole, evaluated at azimuth 0 alone) to 1 (the other).
/// @param rings  steps from pole to pole, at least 2.
/// @return 2 * around * (rings - 1) triangles.
Mesh ball_grid(std::size_t around, std::size_t rings, const SurfacePoint& point);

/// Returns the point of the unit sphere at `azimuth` in revolutions and `height` as a
/// fraction of the meridian from the lowest point to the highest.
Vec3d sphere_point(double azimuth, double height);

/// Returns a shape between ellipsoid and box, such as a cushion: |x|^(2/p) ... (Barr, Superquadrics
/// and Angle-Preserving Transformations, 1981).
/// @param half  of its size along each axis.
/// @param power  1 is an ellipsoid, towards 0 a box.
Mesh superellipsoid(const Vec3d& half, float power, std::size_t around, std::size_t rings);

/// Returns a round tube along a closed chain of points. @param radius  of the tube; below the
/// radius of any bend.
Mesh closed_tube(const std::vector<Vec3d>& chain, double radius, std::size_t around);

/// Returns a torus about the z axis. @param radius  of its centre line. @param thickness  radius of
/// the tube.
Mesh torus(double radius, double thickness, std::size_t along, std::size_t around);

}  // namespace sunfleck::engine
