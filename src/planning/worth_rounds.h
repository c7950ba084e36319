// Worth rounds: trials of photon paths, round after round and epoch after epoch, each round through
// the guide that those before it suggest. All together are a sample of the mixture of these guides.
//
// In:  samples of casters, trials with their guides. Out: the guide that all of them suggest.
// Equations: docs/method/sampling.md, eqs. (38) and (39).
#pragma once

#include "planning/path_trials.h"

#include <memory>
#include <vector>

namespace sunfleck::engine {

/// The brightness of the picture's blocks, which says what light there is worth.
struct WorthScale {
    const BlockGrid& blocks;
    const std::vector<double>& unlit;  // light that needs no photon, summed by block
    Objective objective;
};

class WorthRounds {
public:
    /// A part of all worth, where a trial started.
    using Part = WeightedEmission;

    WorthRounds() = default;
    /// @param casters  samples of where paths to smooth surfaces start.
    explicit WorthRounds(std::vector<WeightedEmission> casters);

    /// Returns whether no path meets anything that bends it.
    bool are_idle() const { return casters_.empty(); }
    /// Returns whether trials have brought light.
    bool have_found() const { return !light_.empty(); }

    /// @param trials  through the guide.
    /// @return the number of trials that brought any light.
    std::size_t add(EmissionGuide guide, const PathTrials& trials);

    /// What trials say.
    struct Advice {
        EmissionGuide guide;
        std::vector<Part> parts;  // sum to one, but for what a single trial may not have
    };
    /// @param over_casters  the share of paths that goes wherever casters are.
    Advice advice(const WorthScale& scale, double over_casters) const;

private:
    struct Round {
        EmissionGuide guide;
        double trials;
    };

    /// What a trial brought.
    struct Brought {
        EmissionPoint point{};
        /// Expected number of trials per volume there, of all rounds. One for a path that brought
        /// nothing, for which nobody asks.
        double density = 1;
        std::size_t begin = 0;  // of its light in light_
        std::size_t end = 0;
    };

    double density(const EmissionPoint& at) const;
    /// Returns the scale of errors of each block.
    std::vector<double> scales(const WorthScale& scale) const;

    std::vector<WeightedEmission> casters_;  // weights sum to one
    std::shared_ptr<const EmissionGuide> over_casters_;
    std::vector<Round> rounds_;
    std::vector<Brought> paths_;    // of all rounds
    std::vector<PathLight> light_;  // of all paths, by path
};

}  // namespace sunfleck::engine
