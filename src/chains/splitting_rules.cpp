// Rules of plans for splitting.
#include "chains/splitting_rules.h"

#include "chains/splitting_tuning.h"

#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

/// Uses the float function, whose bits are the same on every machine.
float log_of(double x) {
    return std::log(static_cast<float>(x));
}

/// Returns the smallest number of sets with a mean conditional fraction of at most
/// kConditionalFraction. @param visible  fraction, positive.
int sets_for(double visible) {
    return static_cast<int>(std::ceil(log_of(visible) / log_of(kConditionalFraction)));
}

const Division& division(const LearnedGuide& map) {
    if (map.covering == GuideCoverage::all_known) return kDivisionAlone;
    return map.visible_share < kSeldomSeen ? kDivisionForSurvivors : kDivisionIfOftenSeen;
}

/// Returns the importance of the guided region such that chains have a fraction `share` of their
/// states there. @param rest  fraction of visible paths outside.
double importance_of(double share, double rest) {
    return std::min(kMostImportance, rest / (1 - rest) * share / (1 - share));
}

/// Returns the number of chains, of at least kStatesOfAChain states so that copies of a survivor
/// diverge.
std::uint32_t chains_for(std::uint32_t states, std::uint32_t most) {
    return std::clamp(states / kStatesOfAChain, 1U, most);
}

/// Returns the heights of the sets before the last: tails nearest to fraction^(k/sets). Sets nearly
/// equal to their neighbours are left out.
std::vector<int> even_heights(const HeightTail& tail, int sets) {
    constexpr double kNearlyTheSame = 0.5;
    const double step = double{log_of(tail[kVisible])} / sets;
    std::vector<int> heights;
    double last = 1;
    int lowest = 1;
    for (int k = 1; k < sets; ++k) {
        int best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int h = lowest; h < kVisible; ++h) {
            const double p = tail.at(static_cast<std::size_t>(h));
            if (p > kNearlyTheSame * last || p * kNearlyTheSame < tail[kVisible]) continue;
            const double miss = std::abs(log_of(p) - k * step);
            if (!(miss < least)) continue;
            least = miss;
            best = h;
        }
        if (best == 0) continue;
        heights.push_back(best);
        last = tail.at(static_cast<std::size_t>(best));
        lowest = best + 1;
    }
    return heights;
}

/// Returns the heights at which the tail decreases, as far as it was reached.
std::vector<int> reached_heights(const HeightTail& tail) {
    constexpr double kLessThanTheLast = 0.2;  // steps that chains of few states still take
    std::vector<int> heights;
    double last = 1;
    for (int h = 1; h < kVisible; ++h) {
        const double p = tail.at(static_cast<std::size_t>(h));
        if (!(p > 0) || p > kLessThanTheLast * last) continue;
        heights.push_back(h);
        last = p;
    }
    return heights;
}

/// @param last_share  fraction of the paths that are states of the last set.
SplittingPlan planned(const HeightTail& tail, std::uint32_t paths, double last_share, Sets sets) {
    if (!is_rare(tail)) return {paths, {}};
    const double visible = tail[kVisible];
    const auto last = std::max(1U, static_cast<std::uint32_t>(last_share * paths));
    const double survivors = visible * (paths - last);
    if (survivors >= kSurvivorsForOneSet) {  // hardly any survivor is left out
        const auto chains = std::max(kLevelChains, static_cast<std::uint32_t>(1.25 * survivors));
        return {paths - last, {{kVisible, last, std::min(last, chains), {}}}};
    }

    std::vector<int> heights;
    if (sets == Sets::as_needed)
        heights = visible > 0 ? even_heights(tail, sets_for(visible)) : reached_heights(tail);
    heights.resize(
        std::min<std::size_t>(heights.size(), paths - last - 1));  // for very small budgets
    const auto shares = static_cast<std::uint32_t>(heights.size() + 1);
    const std::uint32_t share = (paths - last) / shares;
    SplittingPlan plan{paths - last - share * (shares - 1), {}};
    for (const int height : heights)
        plan.levels.push_back({height, share, chains_for(share, kLevelChains), {}});
    plan.levels.push_back({kVisible, last, chains_for(last, kLastChains), {}});
    return plan;
}

}  // namespace

bool is_rare(const HeightTail& tail) {
    return tail[kVisible] < kUniformOnly;
}

SharedPlan shared_plan(HeightTail tail, const LearnedGuide& map, std::uint32_t paths, Sets sets) {
    tail[kVisible] = map.covering == GuideCoverage::all_known ? 0 : tail[kVisible] * map.rest;
    const Division& d = division(map);
    SharedPlan plan;
    plan.guided = {map.map, std::min(static_cast<std::uint32_t>(d.guided * paths), paths - 2),
                   d.detour ? importance_of(*d.detour, map.rest) : 1, d.own};
    plan.splitting = planned(tail, paths - plan.guided.paths, d.last, sets);
    return plan;
}

SplittingPlan splitting_plan(const HeightTail& tail, std::uint32_t paths, Sets sets) {
    return planned(tail, paths, kLastShare, sets);
}

int next_height(const HeightCounts& heights, int from) {
    std::uint64_t all = 0;
    for (const std::uint64_t h : heights) all += h;
    std::uint64_t so_far = 0;
    int lowest = kHeights;
    for (int h = kVisible; h > from; --h) {
        so_far += heights.at(static_cast<std::size_t>(h));
        if (so_far > 0 && 50 * so_far >= all) return h;
        if (heights.at(static_cast<std::size_t>(h)) > 0) lowest = h;
    }
    return lowest;
}

}  // namespace sunfleck::engine
