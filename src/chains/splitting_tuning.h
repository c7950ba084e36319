// The constants of multilevel splitting, its pilot and its chains.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace sunfleck::engine {

// Rules of a plan.
inline constexpr double kUniformOnly = 0.05;  // visible fraction from which there is no splitting
inline constexpr double kSurvivorsForOneSet = 64;
inline constexpr double kConditionalFraction = 0.05;  // of one set in the set before
inline constexpr std::uint32_t kLevelChains = 256;    // of a set
inline constexpr std::uint32_t kLastChains = 1024;    // so that chains cover the picture
inline constexpr std::uint32_t kStatesOfAChain = 64;
inline constexpr double kLastShare = 0.5;  // fraction of paths: states of the last set

// Beside a guide.
inline constexpr double kSeldomSeen = 0.2;      // visible fraction of guided paths
inline constexpr double kMostImportance = 0.5;  // of the guided region

/// Division of the work between guided paths and splitting.
struct Division {
    double guided;  // fraction of all paths
    double last;    // fraction of the splitting paths: states of the last set
    double own;     // fraction of the guided region's light from guided paths
    // Fraction of the last set's states in the guided region; none for as many as occur, since they
    // contribute light.
    std::optional<double> detour;
};
// Guided paths contribute the light of the region. What it does not cover is little but rare:
// uniform paths and the first sets must find it, so the last set has fewer states than without a
// guide.
inline constexpr Division kDivisionIfOftenSeen{
    .guided = 0.35, .last = 0.3, .own = 1, .detour = 0.1};
// No splitting leads to the visible set.
inline constexpr Division kDivisionAlone{.guided = 0.75, .last = 0.5, .own = 1, .detour = 0.25};
// Few guided paths are visible, and they are worth less than states of chains: they start chains.
inline constexpr Division kDivisionForSurvivors{
    .guided = 0.1, .last = 0.75, .own = 0.1, .detour = {}};

// Pilots.
inline constexpr std::uint32_t kUniformPaths = 20'000;  // with which a pilot begins
inline constexpr std::uint32_t kWalkStates = 4'000;     // of an iteration
inline constexpr std::uint32_t kWalkChains = 64;
inline constexpr int kLeastWalkRounds = 3;
inline constexpr int kMostWalkRounds = 12;
inline constexpr int kRefiningIterations = 3;
inline constexpr int kRefiningRest = 6;      // the part outside a guide is narrow
inline constexpr std::uint64_t kLucky = 10;  // at most so many states led to the next level set

// Mutations.
inline constexpr std::size_t kMutationKinds = 2;
/// Scale of bounce dimensions over that of emission dimensions, by kind.
inline constexpr std::array<float, kMutationKinds> kBounceStretch = {1, 16};
/// Target acceptance in sets with few survivors, where chains must explore.
inline constexpr float kTargetAcceptance = 0.5F;
/// Target acceptance in a set that independent paths find often: chains stay near their survivors.
inline constexpr float kTargetOfOneSet = 0.65F;
/// Decades over which magnitudes spread, and the steps of one mutation.
inline constexpr float kDecadesOfMagnitudes = 3;
inline constexpr float kDecadesOfSteps = 1;

}  // namespace sunfleck::engine
