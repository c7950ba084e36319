// Sizes of what a pass and the film hold, fitted to measured peaks.
#include "render/memory_estimate.h"

#include "photon_samplers/samplers.h"
#include "planning/adaptive_pixels.h"
#include "planning/learn_epoch.h"
#include "random_numbers/path_range.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

// Bytes, fitted to the scenes and sizes of docs/reference/render.md.
constexpr std::uint64_t kOnce = std::uint64_t{3} << 20U;
/// Film, pass and picture; of the film, 20 bytes for a second stratum of passes
/// (film/pass_groups.h).
constexpr std::uint64_t kReferencePixel = 240;
/// What learning holds beside these; photons are traced when it is over.
constexpr std::uint64_t kLearningPixel = 650;
/// One more visible point, with its place in the index.
constexpr std::uint64_t kPoint = 400;
/// A channel more, in film, pass and picture.
constexpr std::uint64_t kChannel = 48;

MemoryEstimate sppm_bytes(const RenderJob& job, std::uint64_t pixels) {
    const PhotonSettings& photon = job.settings.photon;
    const std::uint64_t paths = usual_paths(photon, pixels);
    const SamplerMemory memory = memory_of(photon.sampler);
    const std::uint64_t photons = memory.path * std::min(paths, paths_at_once(paths));
    if (!needs_learning(job.scene, job.settings)) {
        const std::uint64_t all = pixels * memory.pixel + photons;
        return {all, all};
    }
    const std::uint64_t usual = pixels * memory.pixel + std::max(pixels * kLearningPixel, photons);
    if (!photon.adaptive_pixels) return {usual, usual};
    return {usual, usual + kPoint * (most_camera_paths(pixels) - pixels)};
}

MemoryEstimate bytes_of_kind(const RenderJob& job, std::uint64_t pixels) {
    if (job.settings.integrator != Integrator::sppm)
        return {pixels * kReferencePixel, pixels * kReferencePixel};
    return sppm_bytes(job, pixels);
}

}  // namespace

std::uint64_t asked_channels(const RenderSettings& settings) {
    std::uint64_t channels = 3 * settings.transport.light_groups.names.size();
    for (std::size_t i = 1; i < kAovCount; ++i)
        if (settings.aovs.at(i)) channels += kAovs.at(i).channels.size();
    return channels;
}

MemoryEstimate render_bytes(const RenderJob& job) {
    const std::uint64_t pixels = window_of(job.scene.film()).pixels();
    const std::uint64_t more = kOnce + pixels * kChannel * asked_channels(job.settings);
    const MemoryEstimate of_kind = bytes_of_kind(job, pixels);
    return {of_kind.usual + more, of_kind.most + more};
}

}  // namespace sunfleck::engine
