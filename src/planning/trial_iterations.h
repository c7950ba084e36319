// Names of the random numbers of trials: iterations of a PilotName beyond all that pilots use.
//
// Camera paths of iterations in one block of kBatchPasses are points of one net
// (random_numbers/batch_points.h), spread more evenly than by chance. Views that are compared as
// independent ones stand in blocks of their own.
#pragma once

#include "math/wavelengths.h"

#include <cstdint>

namespace sunfleck::engine {

inline constexpr std::uint32_t kPixelTrialsIteration = 466;  // subpasses of it: nets of trial paths
inline constexpr std::uint32_t kSecondTrialIteration = 482;
inline constexpr std::uint32_t kExploredTrialIteration = 498;  // the view that planners explore
inline constexpr std::uint32_t kPhotonSetsIteration = 501;     // of the first of two sets

/// The first of a PilotName's iterations begins one.
constexpr std::uint32_t block_of_iteration(std::uint32_t iteration) {
    return iteration / kBatchPasses;
}

static_assert(block_of_iteration(kPixelTrialsIteration) !=
              block_of_iteration(kSecondTrialIteration));
static_assert(block_of_iteration(kPixelTrialsIteration) !=
              block_of_iteration(kExploredTrialIteration));
static_assert(block_of_iteration(kSecondTrialIteration) !=
              block_of_iteration(kExploredTrialIteration));

}  // namespace sunfleck::engine
