// A smooth snifter of brandy with a meniscus: three refracting surfaces, without an air gap.
//
// Unit: centimetres; z up, the foot stands 0.1 mm above the plane z = 0. Each surface separates two
// media; its normal points to the one named second. The three meet in one ring, of the same bits.
#pragma once

#include "procedural/smooth_revolution.h"

namespace sunfleck::engine {

/// Corners of every ring.
inline constexpr std::size_t kSnifterSegments = 256;

struct Snifter {
    Mesh glass_air;     // the whole outside, the rim, and the inside above the brandy
    Mesh brandy_glass;  // the inside of the bowl up to the ring where the brandy ends
    Mesh brandy_air;    // the level, which climbs 2 mm up the wall
};

Snifter snifter();

/// The profiles that the three surfaces are turned from, each with its normals on the side of the
/// medium named second.
struct SnifterProfiles {
    SmoothProfile glass_air;
    SmoothProfile brandy_glass;
    SmoothProfile brandy_air;
};

SnifterProfiles snifter_profiles();

}  // namespace sunfleck::engine
