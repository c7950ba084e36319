// Clusters: the strong ones alone, the weak ones in runs.
#include "light/light_clusters.h"

#include <algorithm>
#include <numeric>

namespace sunfleck::engine {
namespace {

double power_of(const LightRange& source, const LightChoice& weights) {
    double sum = 0;
    for (std::uint32_t i = 0; i < source.count; ++i) sum += weights.probability(source.first + i);
    return sum;
}

void append(const LightRange& source, std::vector<std::uint32_t>& lights) {
    for (std::uint32_t i = 0; i < source.count; ++i) lights.push_back(source.first + i);
}

}  // namespace

std::vector<std::vector<std::uint32_t>> light_clusters(const std::vector<LightRange>& sources,
                                                       const LightChoice& weights,
                                                       std::size_t most) {
    std::vector<LightRange> lit;
    std::vector<double> powers;
    for (const LightRange& source : sources) {
        const double power = power_of(source, weights);
        if (!(power > 0)) continue;
        lit.push_back(source);
        powers.push_back(power);
    }
    const std::size_t alone = lit.size() <= most ? lit.size() : most / 2;
    std::vector<std::size_t> order(lit.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return powers[a] > powers[b]; });
    // Within either half the list's order, which keeps neighbours together.
    const auto weak = order.begin() + static_cast<std::ptrdiff_t>(alone);
    std::sort(order.begin(), weak);
    std::sort(weak, order.end());
    std::vector<std::vector<std::uint32_t>> clusters(std::min(lit.size(), most));
    const std::size_t rest = lit.size() - alone;
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const std::size_t run =
            i < alone ? i : alone + (i - alone) * (clusters.size() - alone) / rest;
        append(lit[order[i]], clusters[run]);
    }
    return clusters;
}

}  // namespace sunfleck::engine
