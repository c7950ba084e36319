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

/// Appends the points t = 1/steps, 2/steps ... 1 of a cubic Bezier curve from the profile's last
/// point. Only + - * / are used, so that bits are the same on every machine. The last point is
/// exact.
/// @param control  second to fourth control points.
/// @param steps  at least 1.
void append_bezier(Profile& profile, const std::array<ProfilePoint, 3>& control, int steps);

/// Revolves the profile around the z axis. Along the profile, the outside is on the right if the
/// radius grows to the right and the height upwards.
/// @param profile   at least two points; radius 0 at the first or last point makes a pole (one
/// point and a fan), all others are rings.
/// @param segments  corners of a ring, at least 3; the first is at x > 0, y = 0.
/// @return 2 * segments triangles between two rings, `segments` between a ring and a pole. Rings of
/// equal radius, height and segments have the same bits in any mesh.
Mesh revolve(const Profile& profile, std::size_t segments);

/// Returns the flat polygon in a ring, with its normal up: segments - 2 triangles, no centre.
Mesh fill_ring(const ProfilePoint& ring, std::size_t segments);

}  // namespace sunfleck::engine
