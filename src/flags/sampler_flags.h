// The flags of single photon samplers: the parts of `adaptive` and of `paper`.
#pragma once

#include "flags/flag.h"

namespace sunfleck {

/// Parts of the sampler `adaptive`, each of which can be left out.
std::vector<RenderFlag> adaptive_flags();

/// What the experiments of the paper's authors vary.
std::vector<RenderFlag> paper_flags();

}  // namespace sunfleck
