// PaperSampler: the paper's method, with one Markov chain for all passes and local radii.
//
// Each pass depends on those before it, and cannot be used alone. A pass's image is
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
    /// Traces a pass. The sum of the statistic "mutation_size" over all passes is the present
    /// theta.
    static PhotonTotals trace(const PhotonPass& pass, const PhotonTarget& target, State& state);
};

}  // namespace sunfleck::engine
