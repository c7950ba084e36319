// One pass of the renderer, as a pure function.
//
// In:  scene, settings, seed and number of the pass. Out: the image of this pass alone, unbiased
// for its radius, and integer counts. So passes may run in any order, on any machine, or again:
// the film only adds them up.
#pragma once

#include "planning/epoch.h"
#include "stages/pass_result.h"

namespace sunfleck::engine {

/// @param epoch  of that pass.
PassResult render_pass(const Scene& scene, const RenderSettings& settings, std::uint32_t number,
                       const Epoch& epoch);

/// The same, learning the epoch by itself.
inline PassResult render_pass(const Scene& scene, const RenderSettings& settings,
                              std::uint32_t number) {
    return render_pass(scene, settings, number, learn_epoch(scene, settings, number));
}

}  // namespace sunfleck::engine
