// The constants of gather discs at the edges of surfaces.
#pragma once

namespace sunfleck::engine {

// Probes of a disc.
/// The series ends after so many terms: a disc with hardly any surface, of a wire or a blade of
/// grass, keeps a part of its loss. More would be noise.
inline constexpr int kMostTerms = 16;
/// Smaller terms go on by Russian roulette.
inline constexpr float kLeastTerm = 0.125F;
/// Surfaces that a probe looks at: others may lie above.
inline constexpr int kMostSurfaces = 4;

// Where discs are probed.
inline constexpr int kCellsOfEdges = 2;   // of a trial in large pictures
inline constexpr int kReach = 2;          // in cells: 25 discs and more vote for one
inline constexpr int kFewVotes = 8;       // as at an outline, or of a surface that is hardly there
inline constexpr float kNoticed = 0.01F;  // of a factor of light

}  // namespace sunfleck::engine
