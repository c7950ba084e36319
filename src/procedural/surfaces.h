// Smooth closed surfaces as fine grids: what has the form of a ring, and what has that of a ball.
//
// A surface is given as a function of two numbers in [0, 1); for outward normals its derivative by
// the first, crossed with that by the second, points out.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

#include <functional>
#include <vector>

namespace sunfleck::engine {

using SurfacePoint = std::function<Vec3d(double, double)>;

/// Closed in both directions. @return 2 * along * around triangles.
Mesh ring_grid(std::size_t along, std::size_t around, const SurfacePoint& point);

/// A ball of any form: point(turn, height) with turn in [0, 1) about the axis, and height from 0
/// (one pole, asked for at turn 0 alone) to 1 (the other). @return 2 * around * (rings - 1)
/// triangles. @param rings  steps from pole to pole, at least 2.
Mesh ball_grid(std::size_t around, std::size_t rings, const SurfacePoint& point);

/// The point of the unit sphere at `turn` about the z axis and `height` of the way from the lowest
/// point to the highest, measured along the meridian.
Vec3d sphere_point(double turn, double height);

/// A ball between sphere and box, such as a cushion: |x|^(2/p) ... (Barr, Superquadrics and
/// Angle-Preserving Transformations, 1981). @param half  of its size along each axis.
/// @param power  1 is an ellipsoid, towards 0 a box.
Mesh superellipsoid(const Vec3d& half, float power, std::size_t around, std::size_t rings);

/// A round tube along a closed chain of points. @param radius  of the tube; smaller than any bend.
Mesh closed_tube(const std::vector<Vec3d>& chain, double radius, std::size_t around);

/// A ring about the z axis. @param radius  of its middle. @param thickness  radius of the tube.
Mesh torus(double radius, double thickness, std::size_t along, std::size_t around);

}  // namespace sunfleck::engine
