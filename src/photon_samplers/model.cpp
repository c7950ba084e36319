// Sums of what photons counted.
#include "photon_samplers/model.h"

#include <utility>

namespace sunfleck::engine {

void PhotonTotals::add_stratum(StratumCounts counts) {
    visible_fraction += counts.power_share * counts.visible_fraction;
    strata.push_back(std::move(counts));
}

}  // namespace sunfleck::engine
