// Names of the random numbers of trials: rounds of a PilotName beyond all that pilots use.
//
// Camera paths of rounds in one block of kRoundPasses are points of one net
// (random_numbers/batch_points.h), spread more evenly than by chance. Views that are compared as
// independent ones stand in blocks of their own.
#pragma once

#include "math/wavelengths.h"

#include <cstdint>

namespace sunfleck {

inline constexpr std::uint32_t kPixelTrialsRound = 466;  // draws of it: nets of trial paths
inline constexpr std::uint32_t kSecondViewRound = 482;
inline constexpr std::uint32_t kSeenViewRound = 498;    // the view that planners explore
inline constexpr std::uint32_t kPhotonSetsRound = 501;  // of the first of two sets

/// The first of a PilotName's rounds begins one.
constexpr std::uint32_t block_of_round(std::uint32_t round) {
    return round / kRoundPasses;
}

static_assert(block_of_round(kPixelTrialsRound) != block_of_round(kSecondViewRound));
static_assert(block_of_round(kPixelTrialsRound) != block_of_round(kSeenViewRound));
static_assert(block_of_round(kSecondViewRound) != block_of_round(kSeenViewRound));

}  // namespace sunfleck
