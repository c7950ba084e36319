// Brightness: the default against references, by equivalence, and error bars against both.
//
// A first look at few renders says where to look twice. The second look takes fresh seeds, so that
// its errors know nothing of the first, and more of them until it can decide.
#pragma once

#include "differential/examine.h"

namespace sunfleck::engine::differential {

/// Adds faults of light, discs and error bars, and says whether the default equals the reference.
/// @throws RenderFault for a render that fails.
void check_light(Renders& renders, const Witnesses& witnesses, const Effort& effort,
                 Findings& findings);

}  // namespace sunfleck::engine::differential
