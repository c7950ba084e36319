// States of a ladder's set that lie in the next set: the seeds of its chains.
#pragma once

#include "sampler/stored_sample.h"

#include <cstdint>
#include <vector>

namespace sunfleck {

/// A state with the number of steps that it stood.
struct Seed {
    StoredSample sample;
    std::uint32_t units = 1;
    int height = 0;  // of its path
};

/// Seeds in a fixed order. A seed of m units counts as m seeds: each starts a chain of its own, or
/// chain lengths would depend on how long the state stood, and with that on where it is.
class Population {
public:
    void add(Seed seed) {
        for (std::uint32_t i = 0; i < seed.units; ++i)
            seed_of_unit_.push_back(static_cast<std::uint32_t>(seeds_.size()));
        seeds_.push_back(std::move(seed));
    }
    void add(std::vector<Seed>&& seeds) {
        for (Seed& seed : seeds) add(std::move(seed));
    }

    /// Those of at least that height.
    Population at_least(int height) const {
        Population some;
        for (const Seed& seed : seeds_)
            if (seed.height >= height) some.add(seed);
        return some;
    }

    std::size_t units() const { return seed_of_unit_.size(); }
    /// @param unit  below units().
    const StoredSample& of_unit(std::size_t unit) const {
        return seeds_[seed_of_unit_[unit]].sample;
    }

private:
    std::vector<Seed> seeds_;
    std::vector<std::uint32_t> seed_of_unit_;
};

}  // namespace sunfleck
