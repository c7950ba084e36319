// A medium that scatters all the light that it stops: free paths through it end where light is
// absorbed, too.
#pragma once

#include "medium/medium.h"

namespace sunfleck::engine {

/// Returns the medium with its absorption counted as scattering.
inline SampledMedium stopping_medium(SampledMedium medium) {
    medium.scattering += medium.absorption;
    medium.absorption = SampledSpectrum(0);
    return medium;
}

}  // namespace sunfleck::engine
