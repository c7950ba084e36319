// Random numbers of trials: iterations of a PilotName beyond those of pilots.
//
// Camera paths of iterations in one block of kBatchPasses are points of one net
// (random_numbers/batch_points.h), better stratified than independent ones. Trials that are
// compared as independent ones use separate blocks.
#pragma once

#include "math/wavelengths.h"
#include "planning/worth_tuning.h"

#include <array>
#include <cstdint>

namespace sunfleck::engine {

inline constexpr std::uint32_t kWaySetsIteration = 416;  // of the first set of photons
inline constexpr std::array<std::uint32_t, 3> kWayCameraIterations = {424, 432, 448};
inline constexpr std::uint32_t kCasterIteration = 433;
inline constexpr std::uint32_t kWorthIteration = 434;  // of the first round of trials
inline constexpr std::uint32_t kBoxesIteration =
    kWorthIteration + kMostWorthRounds;                      // of a round before these
inline constexpr std::uint32_t kPixelTrialsIteration = 464;  // of the first of a net's trials
inline constexpr std::uint32_t kSecondTrialIteration = 482;
inline constexpr std::uint32_t kExploredTrialIteration = 498;  // the trial that planners explore
inline constexpr std::uint32_t kPhotonSetsIteration = 501;     // of the first of two sets
inline constexpr std::uint32_t kMediaSetsIteration = 505;      // the same, for media

/// Returns the first iteration of a block.
constexpr std::uint32_t block_of_iteration(std::uint32_t iteration) {
    return iteration / kBatchPasses;
}

static_assert(kPixelTrialsIteration % kBatchPasses == 0);
static_assert(block_of_iteration(kPixelTrialsIteration) !=
              block_of_iteration(kSecondTrialIteration));
static_assert(block_of_iteration(kPixelTrialsIteration) !=
              block_of_iteration(kExploredTrialIteration));
static_assert(block_of_iteration(kSecondTrialIteration) !=
              block_of_iteration(kExploredTrialIteration));

}  // namespace sunfleck::engine
