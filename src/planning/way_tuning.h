// The constants of the choice of who brings indirect light.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include <cstdint>

namespace sunfleck::engine {

/// Sets of photons at a time, whose differences are their noise.
inline constexpr std::uint32_t kWaySets = 2;
/// Photon paths of a set: fewer would miss the noise of rare ones.
inline constexpr std::uint64_t kPathsOfASet = 100'000;
/// And at most so much of a pass.
inline constexpr std::uint64_t kLeastParts = 4;
/// Camera paths of trials beside the one that was seen; at least those of one trial.
inline constexpr double kCameraPaths = 100'000;

// When trials end: errors over those of the other way.
inline constexpr double kHardlyBetter = 0.7;    // a plan would cost more than it saves
inline constexpr double kClearlyBetter = 0.65;  // more sets are not needed

// Work, in rays of camera paths: fitted to the seconds of 30 scenes (docs/lab/decisions.md).
inline constexpr double kWorkOfPhotonRay = 1.4;
inline constexpr double kWorkOfDeposit = 0.04;  // of a photon on one visible point
inline constexpr double kWorkOfPoint = 1.3;     // another visible point: its index, its lookups

/// Photon paths where nothing in the scene bends light, so that they bring nothing.
inline constexpr std::uint32_t kFewPaths = 1024;

}  // namespace sunfleck::engine
