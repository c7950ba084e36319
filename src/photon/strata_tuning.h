// The constants of light strata.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include <cstddef>
#include <cstdint>

namespace sunfleck::engine {

inline constexpr std::size_t kMostStrata = 4;
/// Visible fractions within this ratio may share a stratum.
inline constexpr std::uint64_t kFractionsApart = 30;

// What is not worth separating.
inline constexpr double kLittlePower = 0.1;  // over that of the more visible stratum
inline constexpr double kLittleFlux = 0.01;  // over that of the less visible one

// Paths of a stratum.
inline constexpr double kLeastShare = 0.1;
inline constexpr double kVisibleOfSplitting = 0.5;  // fraction of its paths

// Measurement of lights, in clusters.
inline constexpr std::size_t kMostClusters = 64;
inline constexpr std::size_t kLeastLightPaths = 1'000;  // of a cluster
inline constexpr std::size_t kMostLightPaths = 4'000;
inline constexpr std::size_t kPathsOfAllLights = 64'000;
inline constexpr std::size_t kMostPathsOfAllLights = 128'000;  // if hardly any are visible

}  // namespace sunfleck::engine
