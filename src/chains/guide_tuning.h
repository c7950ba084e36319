// The constants of emission guides that chains teach, and of the search for where these start.
//
// How errors answer to half and to twice a value: docs/lab/performance.md, "Constants".
#pragma once

#include <cstddef>
#include <cstdint>

namespace sunfleck::engine {

// What a guide learns from.
inline constexpr int kStartingIterations = 4;          // of chains whose starts it learns from
inline constexpr std::uint32_t kGuideTrials = 20'000;  // of an iteration
inline constexpr std::size_t kGuideIterations = 2;
inline constexpr std::size_t kGuideIterationsAlone = 6;  // of a guide that chains do not help
inline constexpr double kUniformAtFirst = 0.5;           // share of its mass
inline constexpr double kUniformLater = 0.25;
inline constexpr double kKeptByWidening = 0.1;
inline constexpr double kLeastGain = 3;            // of a cut, in nats
inline constexpr double kLeastGainAlone = 8;       // its boxes are used as they are
inline constexpr double kMostOfAllStarts = 0.002;  // of the weight of all

// Where it is used.
inline constexpr double kOften = 0.05;      // visible trials in a box
inline constexpr double kLeastRest = 1e-4;  // of visible paths outside: fewer cannot be told
inline constexpr double kMostRest = 0.5;    // of a useful guide

// Importons for guide samples: until many are found, or else a few.
inline constexpr std::uint32_t kWalksAtOnce = 100'000;  // at once
inline constexpr std::uint32_t kFewWalks = 500'000;
inline constexpr std::uint32_t kMostWalks = 8'000'000;
inline constexpr std::size_t kFewGuideSamples = 8;
inline constexpr std::size_t kManyGuideSamples = 2'048;
inline constexpr double kNegligible = 0.01;  // of all visible light: not worth a search
inline constexpr double kEventsMissed = 3;   // upper bound with 95% confidence if none was seen

// Paths from a guide sample until one is visible: fewer do where enough samples lead to one.
inline constexpr int kTriesOfAGuideSample = 256;
inline constexpr int kFewTriesOfAGuideSample = 16;
inline constexpr std::size_t kEnoughVisible = 256;

// Edge search: few tries if light that no importon reached would be spread out, but may be a spot.
inline constexpr std::size_t kManyTries = 200'000;
inline constexpr std::size_t kSomeTries = 20'000;
inline constexpr int kTriesPastEdges = 2;

}  // namespace sunfleck::engine
