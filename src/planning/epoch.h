// Epoch: a range of passes with one plan: camera paths of a pixel, photon paths, light strata and
// who brings indirect light.
//
// Radii shrink ever more slowly, and epochs grow accordingly.
#pragma once

#include "camera_paths/camera_pass.h"
#include "photon/light_stratum.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace sunfleck::engine {

struct CameraTrial;
class WorthRounds;

/// Told of the first trial of an epoch: the seconds that camera paths and index of a whole pass
/// would take, and what it has seen.
using TrialTraced = std::function<void(double seconds, const CameraTrial& seen)>;

/// 0 for passes 0 .. 15, 1 for 16 .. 127, 2 for 128 .. 1023, and so on by factors of eight.
constexpr std::uint32_t epoch_of(std::uint32_t pass) {
    std::uint32_t epoch = 0;
    for (std::uint64_t end = 16; pass >= end; end *= 8) ++epoch;
    return epoch;
}

constexpr std::uint32_t first_pass_of(std::uint32_t epoch) {
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): no epoch is beyond 10
    return epoch == 0 ? 0 : 2U << (3 * epoch);
}

constexpr std::uint32_t passes_of_epoch(std::uint32_t epoch) {
    return first_pass_of(epoch + 1) - first_pass_of(epoch);
}

/// What an epoch's passes share.
struct Epoch {
    std::uint32_t number = 0;
    std::uint32_t paths = 0;                         // photon paths of a pass
    TransportSettings transport{};                   // with the way that brings indirect light
    Log2Samples log2_samples;                        // of a pass's camera paths
    bool is_for_small_passes = false;                // its log2_samples are not chosen yet
    EdgePixels edges;                                // where discs are probed
    std::optional<DirectInMedia> direct_in_media{};  // as CameraPass has it
    std::vector<LightStratum> strata;                // at least one, unless the scene is dark
    std::shared_ptr<const WorthRounds> worth;  // what trials of worth have learned so far, if any
    double seconds = 0;
};

}  // namespace sunfleck::engine
