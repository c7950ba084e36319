// Work of trials in units of about a ray: what is compared where times would differ from run to
// run.
#pragma once

#include "aovs/statistics.h"

namespace sunfleck::engine {

inline constexpr double kRaysOfPath = 0.6;     // work per camera path besides its rays
inline constexpr double kRaysOfDeposit = 0.6;  // of a photon that a visible point accepted

inline double camera_work(const Statistics& counts) {
    return static_cast<double>(counts[Count::camera_rays]) +
           kRaysOfPath * static_cast<double>(counts[Count::camera_paths]);
}

inline double photon_work(const Statistics& counts) {
    return static_cast<double>(counts[Count::photon_rays]) +
           kRaysOfDeposit * static_cast<double>(counts[Count::deposits]);
}

}  // namespace sunfleck::engine
