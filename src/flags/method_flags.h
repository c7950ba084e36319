// The flags about the method: integrator, photon sampler, gather radii.
#pragma once

#include "flags/flag.h"

namespace sunfleck {

/// --photon-sampler stands before the flags that change what a sampler prescribes.
std::vector<RenderFlag> method_flags();

}  // namespace sunfleck
