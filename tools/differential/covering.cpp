// Pairs by a table of states; choices by the best of some random candidates.
#include "differential/covering.h"

#include <algorithm>

namespace sunfleck::engine::differential {
namespace {

/// Choices tried for each that is taken.
constexpr int kCandidates = 12;

std::size_t random_index(RandomStream& random, std::size_t count) {
    return static_cast<std::size_t>(random.next() * static_cast<double>(count));
}

}  // namespace

PairCoverage::PairCoverage(const FeatureTable& table) : table_(&table) {
    for (std::size_t f = 0; f < table.size(); ++f) {
        first_.push_back(total_);
        total_ += table[f].values.size();
    }
    state_.assign(total_ * total_, State::impossible);
    for (std::size_t f = 0; f < table.size(); ++f)
        for (std::size_t g = f + 1; g < table.size(); ++g)
            for (Value a = 0; a < table[f].values.size(); ++a)
                for (Value b = 0; b < table[g].values.size(); ++b) {
                    FeatureTable::Limits limits;
                    table.require(limits, f, a);
                    table.require(limits, g, b);
                    const bool can_be =
                        std::none_of(limits.begin(), limits.end(),
                                     [](const auto& limit) { return limit.second.empty(); });
                    if (!can_be) continue;
                    state_[place(f, a, g, b)] = State::missing;
                    ++possible_;
                }
}

template <class Visit>
void PairCoverage::for_pairs(const Choice& choice, const Visit& visit) const {
    std::vector<std::size_t> meant;
    for (std::size_t f = 0; f < table_->size(); ++f)
        if (table_->has_meaning(choice, f)) meant.push_back(f);
    for (std::size_t i = 0; i < meant.size(); ++i)
        for (std::size_t j = i + 1; j < meant.size(); ++j)
            visit(place(meant[i], choice[meant[i]], meant[j], choice[meant[j]]));
}

void PairCoverage::add(const Choice& choice) {
    for_pairs(choice, [&](std::size_t where) {
        if (state_[where] == State::missing) ++covered_;
        state_[where] = State::covered;
    });
}

std::size_t PairCoverage::gain(const Choice& choice) const {
    std::size_t count = 0;
    for_pairs(choice, [&](std::size_t where) { count += state_[where] == State::missing; });
    return count;
}

std::vector<PairCoverage::Pair> PairCoverage::missing() const {
    std::vector<Pair> pairs;
    for (std::size_t f = 0; f < table_->size(); ++f)
        for (std::size_t g = f + 1; g < table_->size(); ++g)
            for (Value a = 0; a < (*table_)[f].values.size(); ++a)
                for (Value b = 0; b < (*table_)[g].values.size(); ++b)
                    if (is_missing(f, a, g, b)) pairs.push_back({f, a, g, b});
    return pairs;
}

CoveringChoices::CoveringChoices(const FeatureTable& table, std::uint64_t seed)
    : table_(&table), random_(seed, Purpose::test, 0, 0), current_(table) {}

Choice CoveringChoices::next() {
    if (current_.covered() == current_.possible()) current_ = PairCoverage(*table_);
    const std::vector<PairCoverage::Pair> missing = current_.missing();
    Choice best;
    std::size_t best_gain = 0;
    for (int i = 0; i < kCandidates; ++i) {
        Choice choice = candidate(missing);
        const std::size_t gain = current_.gain(choice);
        if (i == 0 || gain > best_gain) {
            best = std::move(choice);
            best_gain = gain;
        }
    }
    current_.add(best);
    return best;
}

/// Holds one of the missing pairs; all other values add as many pairs as they can, one by one.
Choice CoveringChoices::candidate(const std::vector<PairCoverage::Pair>& missing) {
    const PairCoverage::Pair& pair = missing[random_index(random_, missing.size())];
    FeatureTable::Limits limits;
    table_->require(limits, pair.f, pair.a);
    table_->require(limits, pair.g, pair.b);

    std::vector<std::size_t> order(table_->size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t j = random_index(random_, i + 1);
        order[i] = order[j];
        order[j] = i;
    }
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t feature) { return limits.count(feature) > 0; });
    Choice choice(table_->size(), 0);
    std::vector<std::size_t> chosen;
    for (const std::size_t feature : order) {
        choice[feature] = best_value(choice, chosen, feature, limits);
        chosen.push_back(feature);
    }
    return choice;
}

Value CoveringChoices::best_value(const Choice& choice, const std::vector<std::size_t>& chosen,
                                  std::size_t feature, const FeatureTable::Limits& limits) {
    std::vector<Value> values((*table_)[feature].values.size());
    for (Value i = 0; i < values.size(); ++i) values[i] = i;
    if (const auto found = limits.find(feature); found != limits.end()) values = found->second;
    Value best = values.front();
    double best_gain = -1;
    for (const Value value : values) {
        double gain = random_.next() / 2;  // ties at random
        for (const std::size_t other : chosen)
            gain += feature < other ? current_.is_missing(feature, value, other, choice[other])
                                    : current_.is_missing(other, choice[other], feature, value);
        if (gain > best_gain) {
            best = value;
            best_gain = gain;
        }
    }
    return best;
}

}  // namespace sunfleck::engine::differential
