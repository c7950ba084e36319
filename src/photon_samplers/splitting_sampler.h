// SplittingSampler, the sampler `adaptive`: multilevel splitting towards visible paths, and guided
// paths.
#pragma once

#include "photon_samplers/uniform_sampler.h"

namespace sunfleck::engine {

struct SplittingSampler {
    using State = NoState;
    static constexpr PhotonSampler kind = PhotonSampler::adaptive;
    static constexpr std::string_view name = "adaptive";
    static constexpr std::string_view what = "Markov chains over the visible photon paths";
    static constexpr bool learns = true;
    static constexpr SamplerMemory memory = UniformSampler::memory;

    static std::uint32_t default_paths(std::size_t pixels) { return usual_photon_paths(pixels); }
    static std::string settings_text(const PhotonSettings&) { return {}; }
    /// Traces a pass. Strata whose plan has no levels get uniform paths.
    static PhotonTotals trace(const PhotonPass& pass, const PhotonTarget& target, State&);
};

}  // namespace sunfleck::engine
