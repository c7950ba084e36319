// Population: the survivors of a level, states of its chains that lie in the next level set.
#pragma once

#include "chains/target.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sunfleck::engine {

/// A state with the number of its steps.
struct Survivor {
    StoredSample sample;
    std::uint32_t units = 1;
    int height = 0;             // of its path
    double weight = 1;          // of one step
    std::uint32_t lineage = 0;  // number of the independent path that its chains started from

    double total() const { return units * weight; }
};

/// The independent paths that a population descends from: chains move, but never far.
struct Lineages {
    std::uint64_t count = 0;
    double largest_share = 0;  // of the population's weight

    friend bool operator==(const Lineages&, const Lineages&) = default;
};

/// Survivors in a fixed order, as adjacent intervals of a line whose lengths are their weights. A
/// survivor of m steps counts m times; otherwise chain lengths would depend on how long a state was
/// kept, and thus on its position.
class Population {
public:
    void add(Survivor survivor) {
        units_ += survivor.units;
        weight_ += survivor.total();
        ends_.push_back(weight_);
        survivors_.push_back(std::move(survivor));
    }
    void add(std::vector<Survivor>&& survivors) {
        for (Survivor& survivor : survivors) add(std::move(survivor));
    }
    void add(Population&& other) { add(std::move(other.survivors_)); }

    /// Begins a lineage with each survivor, the first of this number.
    void begin_lineages(std::uint64_t first) {
        for (Survivor& survivor : survivors_)
            survivor.lineage = static_cast<std::uint32_t>(first++);
    }

    /// Returns the lineages of positive weight.
    Lineages lineages() const {
        std::unordered_map<std::uint32_t, double> weights;
        for (const Survivor& survivor : survivors_)
            if (survivor.weight > 0) weights[survivor.lineage] += survivor.total();
        Lineages lineages{weights.size(), 0};
        for (const auto& [lineage, weight] : weights)
            lineages.largest_share = std::max(lineages.largest_share, weight / weight_);
        return lineages;
    }

    /// Returns the survivors of at least that height.
    Population at_least(int height) const {
        Population some;
        for (const Survivor& survivor : survivors_)
            if (survivor.height >= height) some.add(survivor);
        return some;
    }

    /// Returns the survivors that no guided path reaches, with the weight of each step times
    /// `weight`.
    Population outside(const GuidedPlan& guided, double weight) && {
        Population some;
        for (Survivor& survivor : survivors_) {
            if (guided.reaches(survivor.sample)) continue;
            survivor.weight *= weight;
            some.add(std::move(survivor));
        }
        return some;
    }

    std::uint64_t units() const { return units_; }
    double weight() const { return weight_; }
    const std::vector<Survivor>& survivors() const { return survivors_; }

    /// Returns the survivor at a position of the line. @param place  in [0, weight()].
    const Survivor& at(double place) const {
        const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, place);
        return survivors_[static_cast<std::size_t>(end - ends_.begin())];
    }

private:
    std::vector<Survivor> survivors_;
    std::vector<double> ends_;  // ends of the survivors' intervals
    std::uint64_t units_ = 0;
    double weight_ = 0;
};

}  // namespace sunfleck::engine
