// Walks from the visible points of each block of a view.
#include "planning/missing_light.h"

#include "photon/importons.h"
#include "planning/photon_trials.h"
#include "planning/trial_iterations.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr int kBlocks = 16;                          // a side
constexpr std::uint32_t kWalks = 512;                // of a block
constexpr std::uint32_t kNoEpoch = (1U << 20U) - 1;  // no render comes so far

/// Block i of so many along an axis.
int edge(int begin, int end, int i) {
    return begin + static_cast<int>((std::int64_t{end} - begin) * i / kBlocks);
}

}  // namespace

double share_lit_by_photons(const Scene& scene, const RenderSettings& settings) {
    if (settings.integrator != Integrator::sppm || scene.is_dark()) return 0;
    const PixelWindow whole = window_of(scene.film());
    const PassId id = PilotName{settings.seed, kNoEpoch}.iteration(kExploredTrialIteration);
    const PassScene at_wavelengths(scene, id);
    std::size_t lit = 0;
    for (int block = 0; block < kBlocks * kBlocks; ++block) {
        const int x = block % kBlocks;
        const int y = block / kBlocks;
        const PixelWindow window{edge(whole.x0, whole.x1, x), edge(whole.y0, whole.y1, y),
                                 edge(whole.x0, whole.x1, x + 1), edge(whole.y0, whole.y1, y + 1)};
        if (window.pixels() == 0) continue;
        const CameraTrial seen =
            view_of({at_wavelengths, settings.transport, settings.camera, window, id});
        if (seen.index.points().empty()) continue;
        const PhotonContext view{at_wavelengths, settings.transport, seen.index};
        const WalkedEmission found = trace_importons(view, scene.light_choice(), id, {0, kWalks});
        if (!found.guide_samples.empty()) lit += window.pixels();
    }
    return static_cast<double>(lit) / static_cast<double>(whole.pixels());
}

}  // namespace sunfleck::engine
