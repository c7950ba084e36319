// Epoch: a range of passes with one plan of their photon paths.
//
// In:  scene, settings, index of the epoch. Out: subpasses of a pass, camera paths of a pixel and
// photon paths of a subpass, light strata and their plans. They are learned by pilots and trials
// from visible points like those of the epoch's first pass alone, so that any pass can be rendered
// anywhere, without earlier ones. Trials are no part of the picture: an allocation computed from
// the pass itself would bias it. Radii shrink ever more slowly, and epochs grow accordingly.
#pragma once

#include "camera_paths/camera_pass.h"
#include "photon/light_stratum.h"
#include "stages/settings.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace sunfleck::engine {

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

/// What an epoch's passes share.
struct Epoch {
    std::uint32_t number = 0;
    std::uint32_t paths = 0;           // photon paths of a subpass
    std::uint32_t subpasses = 1;       // of a pass, which is their mean
    std::uint32_t weight = 1;          // of a pass in the mean over passes
    Log2Samples log2_samples;          // of a subpass's camera paths
    std::vector<LightStratum> strata;  // at least one, unless the scene is dark
    double seconds = 0;
};

/// Returns whether pilots and trials have to run. If not, all epochs are the same but for their
/// numbers.
bool needs_learning(const Scene& scene, const RenderSettings& settings);

/// Returns the epoch of a pass.
/// @param trial_traced  called, long before learning ends, with the seconds that camera paths and
///                      index of one trial took.
Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                  const std::function<void(double)>& trial_traced = {});

}  // namespace sunfleck::engine
