// Case, lid, glass and what hangs on them, mostly turned about the axis of the watch.

#include "procedural/watch_parts.h"

#include "math/trigonometry.h"
#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/surfaces.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kRound = 384;  // corners of a ring of the case
constexpr double kMiddle = 5.2;      // height of crown and bow
constexpr double kLidOpen = 0.253;   // turns from closed
constexpr double kLidRadius = 22.6;

/// Part of a sphere about the axis.
struct Cap {
    double height;  // on the axis
    double sag;     // by how much it is lower at radius `rim`
    double rim;
};

/// Appends points of a cap between two radii, in `steps` steps.
void append_cap(Profile& profile, const Cap& cap, const std::array<double, 2>& radii, int steps) {
    const double curvature_radius = (cap.rim * cap.rim + cap.sag * cap.sag) / (2 * cap.sag);
    for (int i = 0; i <= steps; ++i) {
        const double r = radii[0] + (radii[1] - radii[0]) * i / steps;
        const double drop =
            curvature_radius - std::sqrt(curvature_radius * curvature_radius - r * r);
        profile.push_back({r, cap.height - drop});
    }
}

/// Local x along the axis of the crown, towards +x of the watch, z around it: a turned part.
Placement along_x(double x) {
    return {.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .origin = {x, 0, kMiddle}};
}

Polygon gear(double radius, double depth, std::size_t teeth) {
    Polygon polygon = ellipse(radius, radius, 4 * teeth);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (i % 4 >= 2) polygon[i] *= (radius - depth) / radius;
    return polygon;
}

Mesh crown() {
    Mesh crown = revolve({{0, -4}, {1.7, -4}, {1.7, 0.2}, {2.4, 0.3}, {2.4, 0.6}, {0, 0.6}}, 96);
    crown.append(extrude(gear(2.9, 0.25, 30), {}, 0.4, 3.4));
    Profile top = {{0, 3.2}, {2.5, 3.2}, {2.5, 3.5}};
    append_bezier(top, {{{2.5, 4}, {1, 4.3}, {0, 4.3}}}, 12);
    crown.append(revolve(top, 96));
    return placed(crown, along_x(25));
}

/// A link of a chain, long along x, flat in the plane of x and y.
Mesh link(double half_length, double half_width, double wire) {
    constexpr std::size_t kHalf = 18;
    std::vector<Vec3d> chain;
    for (std::size_t end = 0; end < 2; ++end)
        for (std::size_t i = 0; i <= kHalf; ++i) {
            const SinCos t = sin_cos_2pi(0.5 * static_cast<double>(i) / kHalf - 0.25 +
                                         0.5 * static_cast<double>(end));
            const double shift = (half_length - half_width) * (end == 0 ? 1 : -1);
            chain.emplace_back(shift + half_width * t.cos, half_width * t.sin, 0);
        }
    return closed_tube(chain, wire, 11);
}

/// A point of the line that the chain follows on the table, t from 0 to 2.
Vec3d chain_point(double t) {
    constexpr std::array<Vec3d, 7> kControl = {{{33.2, 0, 1.9},
                                                {45, 1, 1.2},
                                                {54, -9, 1.3},
                                                {46, -24, 1.3},
                                                {38, -39, 1.3},
                                                {14, -26, 1.3},
                                                {-6, -40, 1.3}}};
    const std::size_t first = t < 1 ? 0 : 3;
    const double b = t < 1 ? t : t - 1;
    const double a = 1 - b;
    return kControl.at(first) * (a * a * a) + kControl.at(first + 1) * (3 * a * a * b) +
           kControl.at(first + 2) * (3 * a * b * b) + kControl.at(first + 3) * (b * b * b);
}

}  // namespace

Mesh watch_case() {
    Profile profile = {{0, 0.4}, {11, 0.4}, {11.5, 0.1}, {12.5, 0.1}};
    append_bezier(profile, {{{18, 0.3}, {22, 1.6}, {22.6, 4}}}, 20);
    append_bezier(profile, {{{23.1, 4.2}, {23.1, 5.4}, {22.5, 5.7}}}, 8);
    append_bezier(profile, {{{22.5, 7.2}, {22, 8.6}, {20.9, 8.6}}}, 12);
    append_bezier(profile, {{{20.4, 8.6}, {20, 8.5}, {20, 8.1}}}, 5);
    profile.push_back({20, 5.2});
    profile.push_back({0, 5.2});
    return revolve(profile, kRound);
}

Mesh watch_lid() {
    constexpr double kSag = 6;
    Profile profile;
    append_cap(profile, {kSag - 0.7, kSag - 0.9, kLidRadius - 0.8}, {0, kLidRadius - 0.8}, 18);
    append_bezier(profile, {{{kLidRadius - 0.5, -0.4}, {kLidRadius, -0.4}, {kLidRadius, 0.3}}}, 6);
    append_cap(profile, {kSag, kSag - 0.6, kLidRadius - 0.1}, {kLidRadius - 0.1, 0}, 18);
    const SinCos open = sin_cos_2pi(kLidOpen);
    const Placement opened = {
        .x = {open.cos, 0, open.sin}, .z = {-open.sin, 0, open.cos}, .origin = {-23.6, 0, 8}};
    return placed(revolve(profile, kRound), opened * at({kLidRadius + 0.9, 0, 0}));
}

Mesh watch_cover() {
    Profile profile;
    append_cap(profile, {10.3, 2.6, 19.7}, {0, 19.7}, 24);
    profile.push_back({20.3, 7.7});
    profile.push_back({20.3, 8.2});
    append_cap(profile, {11.3, 2.8, 20}, {20, 0}, 24);
    return revolve(profile, kRound);
}

Mesh watch_fittings() {
    Mesh fittings = crown();
    // The bow is let into the case and leans down to the table.
    const SinCos lean = sin_cos_2pi(-0.052);
    const Placement leaning = {
        .x = {lean.cos, 0, lean.sin}, .z = {-lean.sin, 0, lean.cos}, .origin = {22, 0, kMiddle}};
    fittings.append(placed(torus(5.9, 0.85, 120, 32), leaning * at({5.6, 0, 0})));
    for (const double y : {-5.2, 0.0, 5.2})
        fittings.append(
            placed(extrude(ellipse(0.85, 0.85, 40), {}, -2.5, 2.5), standing(0, {-23.4, y, 7.6})));
    return fittings;
}

Mesh watch_chain() {
    constexpr double kPitch = 3.5;
    constexpr int kFine = 2000;
    Mesh chain;
    const Mesh one = link(2.2, 1.25, 0.36);
    double walked = 0;
    double next = 0.6;
    int count = 0;
    Vec3d last = chain_point(0);
    for (int i = 1; i <= kFine; ++i) {
        const Vec3d here = chain_point(2.0 * i / kFine);
        walked += (here - last).length();
        if (walked >= next) {
            const Vec3d way = (here - last).normalized();
            const Vec3d side = Vec3d(0, 0, 1).cross(way).normalized();
            const Placement along = {.x = way, .y = side, .z = way.cross(side), .origin = here};
            chain.append(placed(one, along * tilted(count % 2 == 0 ? 0.125 : -0.125, Vec3d(0))));
            next += kPitch;
            ++count;
        }
        last = here;
    }
    return chain;
}

}  // namespace sunfleck::engine
