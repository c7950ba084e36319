// A tumbler of iced tea as surfaces between two media each, without air gaps.
//
// Unit: centimetres; z is up, the tumbler stands on the plane z = 0 (0.1 mm above it). Normals
// point to the medium named second. Where three media meet, corners have the same bits in each
// mesh.
#pragma once

#include "procedural/convex.h"
#include "procedural/mesh.h"

#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kTumblerSegments = 128;
inline constexpr double kTeaLevel = 7.5;

struct IcedTea {
    Mesh glass_air;  // the outside, the rim, and the inside above the tea
    Mesh tea_glass;
    Mesh tea_air;  // the level, with a hole for each piece of ice
    Mesh ice_tea;  // below the level
    Mesh ice_air;  // above the level
};

IcedTea iced_tea();

/// Returns the pieces of ice: disjoint convex cubes with bevelled edges and corners.
std::vector<std::vector<HalfSpace>> ice_cubes();

}  // namespace sunfleck::engine
