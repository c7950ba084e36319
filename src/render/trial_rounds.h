// Names of the random numbers of trials: rounds of a PilotName beyond all that pilots use.
#pragma once

#include <cstdint>

namespace sunfleck {

inline constexpr std::uint32_t kSeenViewRound = 498;     // the view that planners explore
inline constexpr std::uint32_t kPixelTrialsRound = 499;  // draws of it: nets of trial paths
inline constexpr std::uint32_t kSecondViewRound = 500;
inline constexpr std::uint32_t kPhotonSetsRound = 501;  // of the first of two sets

}  // namespace sunfleck
