// The sampler `paper`: one chain and one set of counts for all passes, local radii.
//
// Each pass builds on those before, so none can be taken alone. A pass's image is
// P L_P - (P - 1) L_{P-1}, where L_P is the paper's estimate after P passes: the mean over passes,
// which is what a film shows, is L_P.
#pragma once

#include "photon_samplers/model.h"
#include "photon_samplers/paper_memory.h"

#include <string>

namespace sunfleck::engine {

struct PaperSampler {
    using State = PaperMemory;
    static constexpr PhotonSampler kind = PhotonSampler::paper;
    static constexpr std::string_view name = "paper";
    static constexpr std::string_view what =
        "the paper's one chain over all passes, to the letter; biased at finite time";
    static constexpr bool learns = false;
    static constexpr SamplerMemory memory{580, 0};  // its chunks of paths are small

    /// Section 7.
    static std::uint32_t default_paths(std::size_t /*pixels*/) { return 200'000; }
    static std::string settings_text(const PhotonSettings& settings);
    /// The sum of "mutation_size" over all passes is theta as it stands.
    static PhotonTotals trace(const PhotonPass& pass, const PhotonTarget& target, State& state);
};

}  // namespace sunfleck::engine
