// Choices of features in which every pair of values occurs, by a greedy pairwise covering array.
//
// Source: Cohen, Dalal, Fredman, Patton, The AETG System: An Approach to Testing Based on
// Combinatorial Design (1997).
#pragma once

#include "core/random.h"
#include "differential/features.h"

#include <string>
#include <vector>

namespace sunfleck::engine::differential {

/// Which pairs of values occurred in a set of choices.
class PairCoverage {
public:
    explicit PairCoverage(const FeatureTable& table);

    void add(const Choice& choice);
    /// How many pairs the choice would add.
    std::size_t gain(const Choice& choice) const;
    /// Whether these two values are still missing together, and can occur together.
    bool is_missing(std::size_t f, Value a, std::size_t g, Value b) const {
        return state_[place(f, a, g, b)] == State::missing;
    }

    std::size_t possible() const { return possible_; }
    std::size_t covered() const { return covered_; }
    struct Pair {
        std::size_t f;
        Value a;
        std::size_t g;
        Value b;
    };
    std::vector<Pair> missing() const;

private:
    enum class State : char { impossible, missing, covered };
    std::size_t place(std::size_t f, Value a, std::size_t g, Value b) const {
        return (first_[f] + a) * total_ + first_[g] + b;
    }
    template <class Visit>
    void for_pairs(const Choice& choice, const Visit& visit) const;

    const FeatureTable* table_;
    std::vector<std::size_t> first_;  // index of a feature's first value among all values
    std::size_t total_ = 0;           // values of all features
    std::vector<State> state_;        // by two values; of (f, a, g, b) with f < g alone
    std::size_t possible_ = 0;
    std::size_t covered_ = 0;
};

/// An endless series of choices: once all pairs are covered, it covers them again, otherwise.
class CoveringChoices {
public:
    /// The table must outlive it.
    CoveringChoices(const FeatureTable& table, std::uint64_t seed);

    Choice next();

private:
    Choice candidate(const std::vector<PairCoverage::Pair>& missing);
    Value best_value(const Choice& choice, const std::vector<std::size_t>& chosen,
                     std::size_t feature, const FeatureTable::Limits& limits);

    const FeatureTable* table_;
    RandomStream random_;
    PairCoverage current_;  // of the covering under way
};

}  // namespace sunfleck::engine::differential
