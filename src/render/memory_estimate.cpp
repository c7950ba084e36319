// Bytes per pixel, fitted to measured peaks.
#include "render/memory_estimate.h"

#include "render/pass.h"

namespace sunfleck {
namespace {

/// A linear law for one way of rendering.
struct MemoryLaw {
    std::uint64_t once;       // bytes, whatever the size
    std::uint64_t per_pixel;  // film, pass, picture, and visible points where there are any
};

// Fitted to cornell, box, cognac-0 and iced-tea of 64 to 1024 pixels a side (docs/render.md);
// photons are traced some at a time, so that more of them in a pass take no more memory.
constexpr std::uint64_t kMebibyte = 1 << 20;
constexpr MemoryLaw kReference{16 * kMebibyte, 220};
constexpr MemoryLaw kPaper{48 * kMebibyte, 500};
constexpr MemoryLaw kDefault{48 * kMebibyte, 1650};

/// Of a layer's channel, in film, pass and picture.
constexpr std::uint64_t kPerChannel = 48;

const MemoryLaw& law_of(const RenderSettings& settings) {
    if (settings.integrator != Integrator::sppm) return kReference;
    return settings.photon.sampler == PhotonSampler::paper ? kPaper : kDefault;
}

std::uint64_t channels_of(const RenderSettings& settings) {
    std::uint64_t channels = 3 * settings.transport.light_layers.names.size();
    for (std::size_t i = 1; i < kLayerCount; ++i)
        if (settings.layers.at(i)) channels += kLayers.at(i).channels.size();
    return channels;
}

}  // namespace

std::uint64_t render_bytes(const RenderJob& job) {
    const MemoryLaw& law = law_of(job.settings);
    const std::uint64_t pixels = window_of(job.scene.film()).pixels();
    return law.once + pixels * (law.per_pixel + kPerChannel * channels_of(job.settings));
}

}  // namespace sunfleck
