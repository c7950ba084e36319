// Work of trials, from their counts: what is compared where times would differ from run to run.
//
// Costs were fitted to the seconds of 30 scenes, each with both ways of indirect light: a ray of
// photons with its hit, its photon and its share of an index takes 1.4 times as long as a ray of
// camera paths. The fit holds within a third (docs/lab/decisions.md).
#pragma once

#include "aovs/statistics.h"
#include "planning/way_tuning.h"

namespace sunfleck::engine {

inline double camera_work(const Statistics& counts) {
    return static_cast<double>(counts[Count::camera_rays]);
}

inline double photon_work(const Statistics& counts) {
    return kWorkOfPhotonRay * static_cast<double>(counts[Count::photon_rays]) +
           kWorkOfDeposit * static_cast<double>(counts[Count::deposits]);
}

}  // namespace sunfleck::engine
