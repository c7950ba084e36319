// The tumbler turned from its profile; ice cut at the level of the tea.

#include "procedural/iced_tea_glass.h"

#include "procedural/flat_fill.h"
#include "procedural/revolution.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

constexpr double kHalfEdge = 1.12;

/// A cube's middle and its turn as a quaternion, w x y z of any length.
struct Placed {
    Vec3d middle;
    std::array<double, 4> turn;
};

constexpr std::array<Placed, 3> kCubes = {{{{1.72, 0.7, 6.62}, {8, 1, 0.6, 1.5}},
                                           {{-1.58, 1.07, 6.6}, {8, -0.7, 0.9, -2.2}},
                                           {{0.14, -1.82, 6.64}, {8, 0.4, -0.9, 3.1}}}};

Vec3d turned(const std::array<double, 4>& q, const Vec3d& v) {
    const Vec3d axis(q[1], q[2], q[3]);
    const double length2 = q[0] * q[0] + axis.dot(axis);
    const Vec3d across = axis.cross(v);
    return v + (across * q[0] + axis.cross(across)) * (2 / length2);
}

/// Six faces, twelve edges and eight corners, the latter two cut off.
std::vector<HalfSpace> cube(const Placed& placed) {
    constexpr std::array<double, 3> kDistance = {kHalfEdge, 1.86 * kHalfEdge, 2.62 * kHalfEdge};
    std::vector<HalfSpace> half_spaces;
    for (int i = 0; i < 27; ++i) {
        const int up = i / 9;
        const Vec3d direction(i % 3 - 1, i / 3 % 3 - 1, up - 1);
        const auto axes = static_cast<int>(direction.dot(direction));
        if (axes == 0) continue;
        const Vec3d normal = turned(placed.turn, direction);
        half_spaces.push_back(
            {normal, kDistance.at(static_cast<std::size_t>(axes - 1)) + normal.dot(placed.middle)});
    }
    return half_spaces;
}

/// The facets of a body on one side of the level, without the cut itself.
void add_part(Mesh& mesh, std::vector<HalfSpace> body, double up) {
    body.push_back({{0, 0, up}, up * kTeaLevel});
    for (std::size_t i = 0; i + 1 < body.size(); ++i) add_polygon(mesh, facet(body, i));
}

/// Where the level cuts a body: counter-clockwise from above.
Polygon at_level(std::vector<HalfSpace> body) {
    body.push_back({{0, 0, 1}, kTeaLevel});
    return facet(body, body.size() - 1);
}

/// The outside from the middle of the underside over the rim down to the level of the tea, and the
/// inside from there to the axis.
struct TumblerProfile {
    Profile glass_air;
    Profile glass_tea;
};

TumblerProfile tumbler_profile() {
    TumblerProfile profile;
    profile.glass_air = {{0, 0.16}, {2.6, 0.14}, {2.8, 0.01}};
    append_bezier(profile.glass_air, {{{3.1, 0.01}, {3.3, 0.1}, {3.33, 0.4}}}, 6);
    append_bezier(profile.glass_air, {{{3.5, 3}, {3.9, 7}, {4.1, 9.9}}}, 12);
    append_bezier(profile.glass_air, {{{4.11, 10.05}, {3.91, 10.05}, {3.9, 9.9}}}, 6);
    append_bezier(profile.glass_air, {{{3.86, 9.2}, {3.8, 8.4}, {3.74, kTeaLevel}}}, 4);
    profile.glass_tea = {{3.74, kTeaLevel}};
    append_bezier(profile.glass_tea, {{{3.58, 5.6}, {3.3, 3.2}, {3.18, 2}}}, 8);
    append_bezier(profile.glass_tea, {{{3.1, 1.3}, {2.7, 1.1}, {0, 1}}}, 12);
    return profile;
}

}  // namespace

std::vector<std::vector<HalfSpace>> ice_cubes() {
    std::vector<std::vector<HalfSpace>> cubes;
    cubes.reserve(kCubes.size());
    for (const Placed& placed : kCubes) cubes.push_back(cube(placed));
    return cubes;
}

IcedTea iced_tea() {
    TumblerProfile profile = tumbler_profile();
    IcedTea tea;
    tea.glass_air = revolve(profile.glass_air, kTumblerSegments);
    // Walked from the axis upwards, the wall of the tea has the glass on its outside.
    std::reverse(profile.glass_tea.begin(), profile.glass_tea.end());
    tea.tea_glass = revolve(profile.glass_tea, kTumblerSegments);
    std::vector<Polygon> holes;
    for (const auto& body : ice_cubes()) {
        add_part(tea.ice_tea, body, 1);
        add_part(tea.ice_air, body, -1);
        holes.push_back(at_level(body));
    }
    Polygon edge;
    for (const auto& p : fill_ring(profile.glass_tea.back(), kTumblerSegments).points)
        edge.emplace_back(p[0], p[1], p[2]);
    fill(tea.tea_air, edge, holes);
    return tea;
}

}  // namespace sunfleck::engine
