// States of a ladder's set that lie in the next set: the seeds of its chains.
#pragma once

#include "chains/target.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sunfleck {

/// A state with the number of steps that it stood.
struct Seed {
    StoredSample sample;
    std::uint32_t units = 1;
    int height = 0;     // of its path
    double weight = 1;  // of a unit

    double total() const { return units * weight; }
};

/// Seeds in a fixed order, side by side on a line: each as long as its weight. A seed of m units
/// counts as m seeds, or chain lengths would depend on how long the state stood, and with that on
/// where it is.
class Population {
public:
    void add(Seed seed) {
        units_ += seed.units;
        weight_ += seed.total();
        ends_.push_back(weight_);
        seeds_.push_back(std::move(seed));
    }
    void add(std::vector<Seed>&& seeds) {
        for (Seed& seed : seeds) add(std::move(seed));
    }
    void add(Population&& other) { add(std::move(other.seeds_)); }

    /// Those of at least that height.
    Population at_least(int height) const {
        Population some;
        for (const Seed& seed : seeds_)
            if (seed.height >= height) some.add(seed);
        return some;
    }

    /// The same seeds, each unit of that weight times its own, but those that are covered.
    Population uncovered(const MapCover& cover, double weight) && {
        Population some;
        for (Seed& seed : seeds_) {
            if (cover.contains(seed.sample)) continue;
            seed.weight *= weight;
            some.add(std::move(seed));
        }
        return some;
    }

    std::uint64_t units() const { return units_; }
    double weight() const { return weight_; }
    const std::vector<Seed>& seeds() const { return seeds_; }

    /// The seed at a place of the line. @param place  in [0, weight()].
    const StoredSample& at(double place) const {
        const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, place);
        return seeds_[static_cast<std::size_t>(end - ends_.begin())].sample;
    }

private:
    std::vector<Seed> seeds_;
    std::vector<double> ends_;  // of the seeds on the line
    std::uint64_t units_ = 0;
    double weight_ = 0;
};

}  // namespace sunfleck
