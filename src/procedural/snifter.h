// A smooth snifter of brandy with a meniscus: three refracting surfaces, without an air gap.
//
// Unit: centimetres; z up, the foot stands 0.1 mm above the plane z = 0. Each surface separates two
// media; its normal points to the one named second. The three share one ring, of the same bits.
#pragma once

#include "procedural/smooth_revolution.h"

namespace sunfleck::engine {

/// Vertices of each ring.
inline constexpr std::size_t kSnifterSegments = 256;

struct Snifter {
    Mesh glass_air;     // the whole outside, the rim, and the inside above the brandy
    Mesh brandy_glass;  // the inside of the bowl up to the ring where the brandy ends
    Mesh brandy_air;    // the level, which climbs 2 mm up the wall
};

Snifter snifter();

/// Profiles of the three surfaces of revolution. Normals are on the side of the medium that is
/// named second.
struct SnifterProfiles {
    SmoothProfile glass_air;
    SmoothProfile brandy_glass;
    SmoothProfile brandy_air;
};

SnifterProfiles snifter_profiles();

}  // namespace sunfleck::engine
