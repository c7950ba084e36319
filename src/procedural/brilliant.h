// A round brilliant: a diamond cut with 57 facets and a girdle of 16.
#pragma once

#include "procedural/mesh.h"

namespace sunfleck::engine {

/// Proportions of the cut; lengths in units of the girdle's radius.
struct BrilliantCut {
    double table = 0.55;               // radius of the table's corners
    double crown_tangent = 0.6873;     // of 34.5 degrees, between bezel facets and the girdle
    double pavilion_tangent = 0.8617;  // of 40.75 degrees
    double girdle = 0.04;              // height of the girdle
    double star = 0.5;                 // of the way from table to girdle, seen from above
    double lower = 0.77;               // of the way from girdle to culet, for the lower halves
};

/// Axis z, table up, the girdle's lower edge in the plane z = 0 with a corner at (1, 0, 0); the
/// first pavilion facet contains that corner and the culet. Normals outwards.
/// Source: the facets' names and usual proportions are those of gemmology; Tolkowsky, Diamond
/// Design (1919), gives 34.5 and 40.75 degrees.
Mesh brilliant(const BrilliantCut& cut);

}  // namespace sunfleck::engine
