// A tumbler of iced tea, as surfaces between two media each, without an air gap.
//
// Unit: centimetres; z up, the tumbler stands on the plane z = 0 (0.1 mm above it). Normals point
// to the medium named second. Where three media meet, the corners have the same bits in each mesh.
#pragma once

#include "procedural/convex.h"
#include "procedural/mesh.h"

#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kTumblerSegments = 128;
inline constexpr double kTeaLevel = 7.5;

struct IcedTea {
    Mesh glass_air;  // the whole outside, the rim, and the inside above the tea
    Mesh tea_glass;
    Mesh tea_air;  // the level, with a hole for each piece of ice
    Mesh ice_tea;  // below the level
    Mesh ice_air;  // above it
};

IcedTea iced_tea();

/// The pieces of ice: cubes with bevelled edges and corners, convex, without touching.
std::vector<std::vector<HalfSpace>> ice_cubes();

}  // namespace sunfleck::engine
