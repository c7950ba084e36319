// The snifter's profile and the three surfaces turned from it.

#include "procedural/cognac_glass.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Points of the inner curve from the widest place down to the axis that are still in air.
constexpr std::ptrdiff_t kDryInnerPoints = 3;

/// Foot, stem and bowl from the axis below to the rim's outer edge.
Profile outside() {
    Profile profile = {{0, 0.24},     // the underside is hollow
                       {3.15, 0.01},  // the ring that the glass stands on
                       {3.3, 0.04},  {3.36, 0.11}, {3.3, 0.18}, {3.15, 0.22}};
    append_bezier(profile, {{{1.6, 0.4}, {0.42, 0.7}, {0.42, 2.2}}}, 8);
    append_bezier(profile, {{{0.46, 2.9}, {4.35, 2.7}, {4.35, 6.2}}}, 15);
    append_bezier(profile, {{{4.35, 8.6}, {3.25, 10.2}, {2.95, 12}}}, 9);
    return profile;
}

}  // namespace

SnifterProfile snifter_profile() {
    Profile whole = outside();
    whole.push_back({2.89, kSnifterHeight});
    whole.push_back({2.83, 12});
    append_bezier(whole, {{{3.13, 10.2}, {4.22, 8.6}, {4.22, 6.2}}}, 7);
    const auto widest = static_cast<std::ptrdiff_t>(whole.size()) - 1;
    append_bezier(whole, {{{4.22, 3.7}, {2.2, 3.3}, {0, 3.3}}}, 15);
    const auto level = whole.begin() + widest + kDryInnerPoints;
    return {Profile(whole.begin(), level + 1), Profile(level, whole.end())};
}

CognacGlass cognac_glass() {
    const SnifterProfile profile = snifter_profile();
    // Walked from the axis upwards, the wall of the liquid has the glass on its outside.
    Profile upwards = profile.glass_liquid;
    std::reverse(upwards.begin(), upwards.end());
    return {revolve(profile.glass_air, kCognacSegments), revolve(upwards, kCognacSegments),
            fill_ring(upwards.back(), kCognacSegments)};
}

}  // namespace sunfleck::engine
