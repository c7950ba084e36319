// Profiles of a filled glass from its curves, and the meniscus of the drink.

#include "procedural/filled_glass.h"

namespace sunfleck::engine {
namespace {

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

FilledGlassProfiles filled_glass_profiles(const GlassCurves& curves) {
    FilledGlassProfiles profiles;
    for (const CurvePiece& piece : curves.wall)
        append_curve(profiles.glass_air, piece.curve, piece.steps);
    const auto [dry, wet] = split(curves.bottom, curves.liquid_ends);
    append_curve(profiles.glass_air, dry, 4);
    SmoothProfile downwards;
    append_curve(downwards, wet, 64);
    // From the axis upwards, the normal of the drink's wall points to the glass.
    profiles.liquid_glass = reversed(downwards);
    profiles.liquid_air = meniscus(wet[0]);
    return profiles;
}

FilledGlass filled_glass(const GlassCurves& curves, std::size_t segments) {
    const FilledGlassProfiles profiles = filled_glass_profiles(curves);
    return {revolve_smooth(profiles.glass_air, segments),
            revolve_smooth(profiles.liquid_glass, segments),
            revolve_smooth(profiles.liquid_air, segments)};
}

}  // namespace sunfleck::engine
