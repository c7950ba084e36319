// Surfaces of revolution with vertex normals: they shade and refract as the smooth surface.
#pragma once

#include "procedural/revolution.h"

#include <utility>

namespace sunfleck::engine {

/// A cubic Bezier curve of the profile: two ends, and the control points between them.
using ProfileCurve = std::array<ProfilePoint, 4>;

/// A point of a smooth profile and the curve's derivative there.
struct SmoothPoint {
    ProfilePoint position;
    ProfilePoint tangent;  // of any length but zero
};

using SmoothProfile = std::vector<SmoothPoint>;

/// Appends the points t = 1/steps ... 1 of a curve; to an empty profile also its first point.
/// Only + - * /, hence the same bits everywhere. @param steps  at least 1.
void append_curve(SmoothProfile& profile, const ProfileCurve& curve, int steps);

/// Returns the curve as two, split at the parameter t (de Casteljau).
std::pair<ProfileCurve, ProfileCurve> split(const ProfileCurve& curve, double t);

/// Returns the profile in the reverse order.
SmoothProfile reversed(const SmoothProfile& profile);

/// Returns the surface of revolution about the z axis, as revolve() does, with the profile's
/// normals at the vertices. A tangent at the axis is horizontal.
Mesh revolve_smooth(const SmoothProfile& profile, std::size_t segments);

}  // namespace sunfleck::engine
