// The snifter's curves, from the middle of the foot's underside over the rim down to the brandy.

#include "procedural/snifter.h"

namespace sunfleck::engine {
namespace {

struct Piece {
    ProfileCurve curve;
    int steps = 1;
};

/// Each piece begins in the direction in which the previous one ends.
constexpr std::array<Piece, 8> kPieces = {{
    {{{{0, 0.3}, {1.5, 0.3}, {2.3, 0.01}, {3.1, 0.01}}}, 10},       // the hollow underside
    {{{{3.1, 0.01}, {3.3, 0.01}, {3.42, 0.06}, {3.42, 0.14}}}, 6},  // the foot's edge
    {{{{3.42, 0.14}, {3.42, 0.22}, {3.35, 0.25}, {3.22, 0.27}}}, 6},
    {{{{3.22, 0.27}, {1.92, 0.47}, {0.45, 0.6}, {0.45, 2.4}}}, 20},  // up to the stem
    {{{{0.45, 2.4}, {0.45, 4.15}, {4.5, 4}, {4.5, 7.6}}}, 64},       // the bowl
    {{{{4.5, 7.6}, {4.5, 10.1}, {3.3, 11.7}, {2.95, 13.4}}}, 64},
    {{{{2.95, 13.4}, {2.934, 13.478}, {2.854, 13.478}, {2.838, 13.4}}}, 8},  // the rim
    {{{{2.838, 13.4}, {3.188, 11.7}, {4.36, 10.1}, {4.36, 7.6}}}, 64},       // the inside
}};

/// The inside from the widest place down to the axis, and how far along it the brandy ends.
constexpr ProfileCurve kBottom = {{{4.36, 7.6}, {4.36, 5.15}, {2.5, 4.75}, {0, 4.75}}};
constexpr double kBrandyEnds = 0.05;

/// From the wall, where it stands at 25 degrees, to the axis.
SmoothProfile meniscus(const ProfilePoint& wall) {
    const double level = wall.height - 0.2;
    const double flat = wall.radius - 0.7;  // flat from here inwards
    SmoothProfile profile;
    append_curve(profile,
                 {wall,
                  {wall.radius - 0.06, wall.height - 0.13},
                  {wall.radius - 0.25, level},
                  {flat, level}},
                 12);
    append_curve(profile, {{{flat, level}, {flat * 0.66, level}, {flat * 0.33, level}, {0, level}}},
                 4);
    return profile;
}

}  // namespace

SnifterProfiles snifter_profiles() {
    SnifterProfiles profiles;
    for (const Piece& piece : kPieces) append_curve(profiles.glass_air, piece.curve, piece.steps);
    const auto [dry, wet] = split(kBottom, kBrandyEnds);
    append_curve(profiles.glass_air, dry, 4);
    SmoothProfile downwards;
    append_curve(downwards, wet, 64);
    // From the axis upwards, the normal of the brandy's wall points to the glass.
    profiles.brandy_glass = reversed(downwards);
    profiles.brandy_air = meniscus(wet[0]);
    return profiles;
}

Snifter snifter() {
    const SnifterProfiles profiles = snifter_profiles();
    return {revolve_smooth(profiles.glass_air, kSnifterSegments),
            revolve_smooth(profiles.brandy_glass, kSnifterSegments),
            revolve_smooth(profiles.brandy_air, kSnifterSegments)};
}

}  // namespace sunfleck::engine
