// A snifter of brandy on a table: three refracting surfaces, without an air gap between them.
//
// Unit: centimetres; z up, the glass stands on the plane z = 0 (its foot's edge 0.1 mm above it).
// Each surface separates two media; its normal points to the one named second:
//   glass_air     glass | air      the whole outside, the rim, and the inside above the liquid
//   liquid_glass  liquid | glass   the inside of the bowl up to the level
//   liquid_air    liquid | air     the level, flat
// The three meet in one ring of points, the same bits in each mesh.
#pragma once

#include "procedural/mesh.h"
#include "procedural/revolution.h"

#include <cstddef>

namespace sunfleck::engine {

/// Corners of every ring. With the 60 rings of the glass, the liquid's top (segments - 2
/// triangles) and a table of two triangles: 136 * 121 = 16,456 triangles, as in the paper's Table I
/// (Hachisuka and Jensen, Robust Adaptive Photon Tracing using Photon Path Visibility, 2011).
inline constexpr std::size_t kCognacSegments = 136;

/// Height of the rim, in cm.
inline constexpr double kSnifterHeight = 12.06;

/// The two halves of the closed profile of the glass: first from the middle of the foot's
/// underside along the outside over the rim down to the level; then from there to the axis.
struct SnifterProfile {
    Profile glass_air;
    Profile glass_liquid;  // begins with the last point of glass_air
};

SnifterProfile snifter_profile();

struct CognacGlass {
    Mesh glass_air;
    Mesh liquid_glass;
    Mesh liquid_air;
};

CognacGlass cognac_glass();

}  // namespace sunfleck::engine
