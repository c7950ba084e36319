// Surfaces of revolution about the z axis, as flat triangles without vertex normals.
#pragma once

#include "procedural/mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace sunfleck::engine {

/// A point of a profile: distance from the z axis and height, in the scene's unit.
struct ProfilePoint {
    double radius = 0;
    double height = 0;
};

using Profile = std::vector<ProfilePoint>;

/// Appends the points t = 1/steps, 2/steps ... 1 of a cubic Bezier curve that starts at the
/// profile's last point; only + - * /, hence the same bits everywhere. The last point is exact.
/// @param control  the curve's second to fourth control points. @param steps  at least 1.
void append_bezier(Profile& profile, const std::array<ProfilePoint, 3>& control, int steps);

/// Turns the profile around the z axis. Whoever walks along it has the outside on the right hand
/// when the radius grows to the right and the height upwards.
/// @param profile   radius 0 at the first or last point makes a pole, one point and a fan; all
///                  others are rings. At least two points.
/// @param segments  corners of a ring, at least 3; the first lies at x > 0, y = 0.
/// @return 2 * segments triangles between two rings, `segments` between a ring and a pole. Rings
/// of the same radius, height and segments have the same bits in any mesh.
Mesh revolve(const Profile& profile, std::size_t segments);

/// The flat polygon inside one ring, with its normal up: segments - 2 triangles, no centre.
Mesh fill_ring(const ProfilePoint& ring, std::size_t segments);

}  // namespace sunfleck::engine
