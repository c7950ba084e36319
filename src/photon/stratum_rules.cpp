// The rules and their constants.
#include "photon/stratum_rules.h"

#include "photon/strata_tuning.h"

#include <algorithm>
#include <numeric>

namespace sunfleck::engine {
namespace {

/// Lights of a stratum that is being formed.
struct Stratum {
    std::vector<std::size_t> lights;
    double power = 0;
    double visible_flux = 0;

    void add(const Stratum& other) {
        lights.insert(lights.end(), other.lights.begin(), other.lights.end());
        power += other.power;
        visible_flux += other.visible_flux;
    }
};

/// Goes from the most visible light down; starts a new stratum if a light is too far from its
/// first.
std::vector<Stratum> strata_of(const std::vector<MeasuredLight>& lights) {
    const auto seen = [&](std::size_t i) { return std::max<std::uint64_t>(lights[i].visible, 1); };
    std::vector<std::size_t> order(lights.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return seen(a) > seen(b); });
    std::vector<Stratum> strata;
    for (const std::size_t i : order) {
        const MeasuredLight& light = lights[i];
        if (strata.empty() || seen(i) * kFractionsApart < seen(strata.back().lights.front()))
            strata.emplace_back();
        const double flux =
            light.power * static_cast<double>(light.visible) / static_cast<double>(light.paths);
        strata.back().add({{i}, light.power, flux});
    }
    return strata;
}

/// Returns whether the less visible stratum would slow down the other, and whether the other
/// matters.
bool are_worth_separating(const Stratum& more, const Stratum& less) {
    return less.power >= kLittlePower * more.power &&
           more.visible_flux >= kLittleFlux * less.visible_flux;
}

}  // namespace

std::vector<std::vector<std::size_t>> stratified(const std::vector<MeasuredLight>& lights) {
    std::vector<Stratum> strata;
    for (const Stratum& part : strata_of(lights)) {
        const bool parted = strata.empty() || (strata.size() < kMostStrata &&
                                               are_worth_separating(strata.back(), part));
        if (parted) strata.emplace_back();
        strata.back().add(part);
    }
    std::vector<std::vector<std::size_t>> lists;
    for (Stratum& stratum : strata) {
        std::sort(stratum.lights.begin(), stratum.lights.end());
        lists.push_back(std::move(stratum.lights));
    }
    return lists;
}

std::vector<std::uint32_t> shared_paths(const std::vector<StratumFlux>& strata,
                                        std::uint32_t paths) {
    constexpr std::uint32_t kLeast = 2;
    std::vector<double> shares;
    double all = 0;
    for (const StratumFlux& stratum : strata) {  // uniform paths: the fraction cancels
        const double fraction =
            stratum.has_splitting ? stratum.visible_fraction / kVisibleOfSplitting : 1;
        shares.push_back(stratum.power * fraction);
        all += shares.back();
    }
    double sum = 0;
    for (double& share : shares) {
        share = all > 0 ? std::max(kLeastShare, share / all) : 1;
        sum += share;
    }
    const auto count = static_cast<std::uint32_t>(strata.size());
    const std::uint32_t free = paths - count * kLeast;
    std::vector<std::uint32_t> numbers;
    std::uint32_t left = free;
    for (std::size_t g = 0; g < strata.size(); ++g) {
        const auto share = static_cast<std::uint32_t>(free * (shares[g] / sum));
        numbers.push_back(kLeast + std::min(share, left));
        left -= std::min(share, left);
    }
    numbers.front() += left;  // remainder of rounding
    return numbers;
}

}  // namespace sunfleck::engine
