// The constants of adaptive pixel sampling and of the trials that it is learned from.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunfleck::engine {

// What planners explore: one path in a cell, of so many cells; and narrower discs in large
// pictures.
inline constexpr double kPathsOfATrial = 65'536;
inline constexpr std::size_t kLargePicture = 1'000'000;  // pixels: trials see one in four

// Trials.
inline constexpr int kCellsOfPixelTrials = 2;              // one path per 2 x 2 pixels
inline constexpr int kCellsOfFirstTrials = 3;              // in the first epoch
inline constexpr std::uint32_t kPartsOfPhotons = 4;        // a set has a fraction of a pass's paths
inline constexpr std::uint32_t kPartsOfFirstPhotons = 16;  // in the first epoch, or more:
inline constexpr std::uint32_t kMostPathsOfAFirstSet = 50'000;
inline constexpr std::uint32_t kPassesOfAPairOfNets = 32;  // of those before an epoch
inline constexpr std::uint32_t kMostPairsOfNets = 8;

// Allocations.
inline constexpr std::uint8_t kMostLog2Samples = 6;
/// Paths of a pixel of mean noise, if numbers were real and samples independent.
inline constexpr std::array<double, 8> kAllocationLevels = {0.125, 0.25, 0.5, 1, 2, 4, 8, 16};
/// Camera paths of a pass at most: a visible point takes a few hundred bytes.
inline constexpr std::size_t kMostCameraPaths = std::size_t{1} << 23U;

// The choice.
inline constexpr double kWorthwhile = 0.96;  // of the error: worth more camera paths

}  // namespace sunfleck::engine
