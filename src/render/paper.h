// Passes of the sampler `paper`: one chain and one set of counts for all of them, local radii.
//
// In:  scene, settings. Out: passes in their order; each builds on those before, so none can be
// taken alone. A pass's image is P L_P - (P - 1) L_{P-1}, where L_P is the paper's estimate after P
// passes: the mean over passes, which is what a film shows, is L_P.
#pragma once

#include "film/film.h"
#include "photon/paper_chain.h"
#include "render/local_radii.h"
#include "render/pass.h"

#include <array>
#include <atomic>

namespace sunfleck {

class PaperRender {
public:
    PaperRender(const Scene& scene, const RenderSettings& settings);

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
    std::uint32_t passes_ = 0;
    PaperState chain_;
    LocalRadii radii_;
    std::array<FixedPoints, kLayerCount> flux_;  // tau / (pi R^2 paths), before normalisation
    double shown_ = 0;                           // what flux_ was multiplied by after the last pass
    double theta_counted_ = 0;
    std::uint64_t floor_counted_ = 0;
    std::uint64_t dropped_ = 0;                // of the last pass's photons
    std::atomic<std::uint64_t> saturated_{0};  // the same, and of its differences
};

}  // namespace sunfleck
