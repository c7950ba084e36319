// The constants of guides by worth: their rounds of trials, their shape, the bound of weights.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include "guide/emission_guide.h"

#include <cstdint>

namespace sunfleck::engine {

// Rounds of the first epoch: a part of a pass's paths each, until few more trials are visible.
inline constexpr std::uint32_t kLeastWorthTrials = 2'000;
inline constexpr std::uint32_t kPartsOfAPass = 4;
inline constexpr std::uint32_t kMostFirstTrials = 50'000;
inline constexpr std::uint32_t kLeastRounds = 3;
inline constexpr std::uint32_t kMostWorthRounds = 8;
inline constexpr std::size_t kFewVisible = 50;  // one visible trial in so many is enough

// Those of a later epoch, with a share of the epoch's paths in all.
inline constexpr std::uint32_t kLaterRounds = 2;
inline constexpr double kWorthEffort = 0.03;
inline constexpr double kMostLaterTrials = 250'000;  // of a round: more take longer than they save

// The guide.
inline constexpr EmissionGuide::Growth kWorthGrowth{
    .uniform_share = 0.05, .least_gain = 4, .spread = 0.01};
/// Of its mass: a lasting share of where samples of casters and trials were.
inline constexpr double kWorthKept = 0.3;
/// The guide of samples of casters alone, and its share of a pass's paths and of trials: these find
/// what the guide misses.
inline constexpr EmissionGuide::Growth kCasterGrowth{
    .uniform_share = 0.02, .least_gain = 4, .spread = 0.005};
inline constexpr double kOverCasters = 0.1;
inline constexpr double kOverCastersInTrials = 0.3;
/// Of all trials' weight: one that met a hole of the guide must not become its only goal.
inline constexpr double kMostOfAllWorth = 0.002;

// What bounded weights leave to chains.
inline constexpr double kLeftToChains = 0.01;  // of all worth
inline constexpr std::uint32_t kPathsOfAState = 20;
inline constexpr std::uint32_t kStatesOfARemainderChain = 32;

}  // namespace sunfleck::engine
