// Sums of what photons counted.
#include "photon_samplers/model.h"

#include <utility>

namespace sunfleck::engine {

void PhotonTotals::add_stratum(StratumCounts counts) {
    visible_fraction += counts.power_share * counts.visible_fraction;
    strata.push_back(std::move(counts));
}

void PhotonTotals::add(const PhotonTotals& subpass, double share) {
    statistics += subpass.statistics;
    visible_fraction += subpass.visible_fraction * share;
    strata.resize(subpass.strata.size());
    for (std::size_t g = 0; g < strata.size(); ++g) strata[g].add(subpass.strata[g], share);
    sums.insert(sums.end(), subpass.sums.begin(), subpass.sums.end());
}

}  // namespace sunfleck::engine
