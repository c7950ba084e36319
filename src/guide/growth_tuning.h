// The constants of the growth of emission guides.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include <cstddef>

namespace sunfleck::engine {

// Cuts.
inline constexpr std::size_t kBins = 8;         // positions of cuts, per dimension
inline constexpr double kLeastWidth = 0x1p-32;  // of a box that is cut: dimensions have 52 bits
inline constexpr double kLeastEffective = 12;   // points in a box that is cut

// Shears.
inline constexpr double kLeastToShear = 40;    // points in a box that is sheared: of four slopes
inline constexpr double kLeastShear = 0.35;    // log likelihood per point: half of the variance
inline constexpr std::size_t kMostShears = 8;  // on the way to a box

// Worth of boxes.
inline constexpr double kOfParent = 8;  // trials that the box around one is worth
/// Density of points over that of the box around, below which a box is drawn to less.
inline constexpr double kSparse = 0.25;

}  // namespace sunfleck::engine
