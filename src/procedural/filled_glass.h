// A glass and the drink in it, by revolution: three smooth refracting surfaces, without an air gap.
//
// Unit: centimetres; z up, the foot stands 0.1 mm above the plane z = 0. Each surface separates two
// media; its normal points to the one named second. The three share one ring, of the same bits.
#pragma once

#include "procedural/smooth_revolution.h"

#include <span>

namespace sunfleck::engine {

/// A curve of the profile, and the steps it is cut into.
struct CurvePiece {
    ProfileCurve curve;
    int steps = 1;
};

/// What makes one glass differ from another.
struct GlassCurves {
    /// From the middle of the foot's underside over the rim down to the widest place inside.
    std::span<const CurvePiece> wall;
    ProfileCurve bottom;     // the inside from there to the axis
    double liquid_ends = 0;  // how far along the bottom's curve the drink ends, in (0,1)
};

/// Profiles of the three surfaces of revolution.
struct FilledGlassProfiles {
    SmoothProfile glass_air;
    SmoothProfile liquid_glass;
    SmoothProfile liquid_air;
};

FilledGlassProfiles filled_glass_profiles(const GlassCurves& curves);

struct FilledGlass {
    Mesh glass_air;     // the whole outside, the rim, and the inside above the drink
    Mesh liquid_glass;  // the inside of the bowl up to the ring where the drink ends
    Mesh liquid_air;    // the level, which climbs 2 mm up the wall
};

/// @param segments  vertices of each ring.
FilledGlass filled_glass(const GlassCurves& curves, std::size_t segments);

}  // namespace sunfleck::engine
