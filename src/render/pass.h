// One pass of the renderer, as a pure function.
//
// In:  scene, settings, seed and number of the pass. Out: the image of this pass alone, unbiased
// for its radius, and integer counts. So passes may run in any order, on any machine, or again:
// the film only adds them up. A photon sampler with a state is the exception: its state is an
// argument, too, and its passes have an order.
// Equations: docs/method/method.md, eq. (1).
#pragma once

#include "photon_samplers/sampler_state.h"
#include "planning/learn_epoch.h"
#include "stages/pass_result.h"

namespace sunfleck::engine {

/// @param epoch  of that pass.
/// @param state  of the photon sampler: as the pass before left it, and as this pass leaves it.
PassResult render_pass(const Scene& scene, const RenderSettings& settings, std::uint32_t number,
                       const Epoch& epoch, SamplerState& state);

/// The same with a sampler whose passes are independent of each other.
inline PassResult render_pass(const Scene& scene, const RenderSettings& settings,
                              std::uint32_t number, const Epoch& epoch) {
    SamplerState none;
    return render_pass(scene, settings, number, epoch, none);
}

/// The same, learning the epoch by itself.
inline PassResult render_pass(const Scene& scene, const RenderSettings& settings,
                              std::uint32_t number) {
    return render_pass(scene, settings, number, learn_epoch(scene, settings, number));
}

}  // namespace sunfleck::engine
