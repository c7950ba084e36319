// Bezier profiles, their revolution, and its normals.

#include "procedural/smooth_revolution.h"

#include "math/trigonometry.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

ProfilePoint between(const ProfilePoint& a, const ProfilePoint& b, double t) {
    return {a.radius + (b.radius - a.radius) * t, a.height + (b.height - a.height) * t};
}

/// Returns the curve's point and derivative by de Casteljau's construction.
SmoothPoint point_at(const ProfileCurve& curve, double t) {
    const auto [first, second] = split(curve, t);
    const ProfilePoint& from = t < 1 ? first[3] : first[2];
    const ProfilePoint& to = t < 1 ? second[1] : first[3];
    return {first[3], {to.radius - from.radius, to.height - from.height}};
}

}  // namespace

void append_curve(SmoothProfile& profile, const ProfileCurve& curve, int steps) {
    if (profile.empty()) profile.push_back(point_at(curve, 0));
    for (int i = 1; i < steps; ++i)
        profile.push_back(point_at(curve, static_cast<double>(i) / steps));
    profile.push_back({curve[3], point_at(curve, 1).tangent});
}

std::pair<ProfileCurve, ProfileCurve> split(const ProfileCurve& curve, double t) {
    const ProfilePoint a = between(curve[0], curve[1], t);
    const ProfilePoint b = between(curve[1], curve[2], t);
    const ProfilePoint c = between(curve[2], curve[3], t);
    const ProfilePoint ab = between(a, b, t);
    const ProfilePoint bc = between(b, c, t);
    const ProfilePoint middle = between(ab, bc, t);
    return {{curve[0], a, ab, middle}, {middle, bc, c, curve[3]}};
}

SmoothProfile reversed(const SmoothProfile& profile) {
    SmoothProfile result(profile.rbegin(), profile.rend());
    for (SmoothPoint& point : result)
        point.tangent = {-point.tangent.radius, -point.tangent.height};
    return result;
}

Mesh revolve_smooth(const SmoothProfile& profile, std::size_t segments) {
    Profile positions(profile.size());
    std::transform(profile.begin(), profile.end(), positions.begin(),
                   [](const SmoothPoint& point) { return point.position; });
    Mesh mesh = revolve(positions, segments);
    for (const auto& [position, tangent] : profile) {
        const double length =
            std::sqrt(tangent.radius * tangent.radius + tangent.height * tangent.height);
        const double out = tangent.height / length;
        const auto up = static_cast<float>(-tangent.radius / length);
        const std::size_t count = position.radius == 0 ? 1 : segments;
        for (std::size_t i = 0; i < count; ++i) {
            const SinCos at = sin_cos_2pi(static_cast<double>(i) / static_cast<double>(segments));
            mesh.normals.push_back(
                {static_cast<float>(out * at.cos), static_cast<float>(out * at.sin), up});
        }
    }
    return mesh;
}

}  // namespace sunfleck::engine
