// Epochs: runs of passes with one plan of their photon paths.
//
// In:  scene, settings, number of the epoch. Out: subpasses of a pass, camera paths of a pixel and
// photon paths of a subpass, strata of lights and their plans, learned by pilots and trials over
// views like that of the epoch's first pass, and by nothing else: so any pass can be rendered
// anywhere, without those before it. The views are no part of the picture: paths that were shared
// out by what a pass itself has seen would bias it. Radii shrink as passes go on, ever more slowly,
// and so do epochs grow.
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
    return epoch == 0 ? 0 : 2U << (3 * epoch);
}

/// What an epoch's passes share.
struct Epoch {
    std::uint32_t number = 0;
    std::uint32_t paths = 0;           // photon paths of a subpass
    std::uint32_t subpasses = 1;       // of a pass, which is their mean
    std::uint32_t weight = 1;          // of a pass: how often it counts in the picture
    Log2Samples log2_samples;          // of a subpass's camera paths
    std::vector<LightStratum> strata;  // at least one, unless the scene is dark
    double seconds = 0;
};

/// Is there anything to learn? If not, each epoch is the same but for its number.
bool needs_learning(const Scene& scene, const RenderSettings& settings);

/// The epoch that a pass belongs to.
/// @param view_traced  told the seconds that a view took: the camera paths of a pass, and their
///                     index. Long before the end of learning.
Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                  const std::function<void(double)>& view_traced = {});

}  // namespace sunfleck::engine
