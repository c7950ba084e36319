// Passes of the sampler `paper`: one chain and one set of counts for all of them, local radii.
//
// In:  scene, settings. Out: passes in their order; each builds on those before, so none can be
// taken alone. A pass's image is P L_P - (P - 1) L_{P-1}, where L_P is the paper's estimate after P
// passes: the mean over passes, which is what a film shows, is L_P.
#pragma once

#include "paper/paper_memory.h"
#include "stages/pass_result.h"

#include <atomic>

namespace sunfleck::engine {

class PaperRender {
public:
    /// @param memory  of the same settings and picture; outlives this, which goes on from it.
    PaperRender(const Scene& scene, const RenderSettings& settings, PaperMemory& memory);

    /// The next pass.
    PassResult next_pass();

    /// Adds to the film what the last pass counted beside its result: "mutation_size" (the sum
    /// over all passes is theta as it stands) and "theta_floor_held". Once after each pass.
    void count(Film& film);

private:
    FixedPoint scaled(const FixedPoint& flux, double factor);
    void add_photon_light(const PassImage& photons, PassImage& image);

    const Scene& scene_;
    const RenderSettings& settings_;
    PixelWindow window_;
    std::uint32_t paths_;
    PaperMemory& memory_;
    std::uint64_t dropped_ = 0;                // of the last pass's photons
    std::atomic<std::uint64_t> saturated_{0};  // the same, and of its differences
};

}  // namespace sunfleck::engine
