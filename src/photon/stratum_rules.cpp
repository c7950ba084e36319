// The rules and their constants.
#include "photon/stratum_rules.h"

#include <algorithm>
#include <numeric>

namespace sunfleck::engine {
namespace {

constexpr double kLittlePower = 0.1;
constexpr double kLittleFlux = 0.01;
constexpr double kLeastShare = 0.1;

/// Lights that share a stratum, as far as it is made.
struct Part {
    std::vector<std::size_t> lights;
    double power = 0;
    double visible_flux = 0;

    void add(const Part& other) {
        lights.insert(lights.end(), other.lights.begin(), other.lights.end());
        power += other.power;
        visible_flux += other.visible_flux;
    }
};

/// From the most visible light down; a new part where one is too far from the part's first.
std::vector<Part> parts_of(const std::vector<MeasuredLight>& lights) {
    const auto seen = [&](std::size_t i) { return std::max<std::uint64_t>(lights[i].visible, 1); };
    std::vector<std::size_t> order(lights.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return seen(a) > seen(b); });
    std::vector<Part> parts;
    for (const std::size_t i : order) {
        const MeasuredLight& light = lights[i];
        if (parts.empty() || seen(i) * kFractionsApart < seen(parts.back().lights.front()))
            parts.emplace_back();
        const double flux =
            light.power * static_cast<double>(light.visible) / static_cast<double>(light.paths);
        parts.back().add({{i}, light.power, flux});
    }
    return parts;
}

/// May the less visible of two parts be in the other's way, and does the other matter?
bool are_worth_parting(const Part& more, const Part& less) {
    return less.power >= kLittlePower * more.power &&
           more.visible_flux >= kLittleFlux * less.visible_flux;
}

}  // namespace

std::vector<std::vector<std::size_t>> stratified(const std::vector<MeasuredLight>& lights) {
    std::vector<Part> strata;
    for (const Part& part : parts_of(lights)) {
        const bool parted = strata.empty() ||
                            (strata.size() < kMostStrata && are_worth_parting(strata.back(), part));
        if (parted) strata.emplace_back();
        strata.back().add(part);
    }
    std::vector<std::vector<std::size_t>> lists;
    for (Part& stratum : strata) {
        std::sort(stratum.lights.begin(), stratum.lights.end());
        lists.push_back(std::move(stratum.lights));
    }
    return lists;
}

std::vector<std::uint32_t> shared_paths(const std::vector<StratumFlux>& strata,
                                        std::uint32_t paths) {
    constexpr std::uint32_t kLeast = 2;
    constexpr double kVisibleOfSplitting = 0.5;
    std::vector<double> shares;
    double all = 0;
    for (const StratumFlux& stratum : strata) {  // uniform paths: the fraction falls out
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
    numbers.front() += left;  // what rounding left
    return numbers;
}

}  // namespace sunfleck::engine
