// How a render answers signals, by what it is doing.
#pragma once

#include "apps/cli/interrupt.h"
#include "apps/cli/options.h"

namespace sunfleck::engine {

/// Until the first pass begins there is nothing to finish, and a signal ends the program at once.
enum class RenderStep { reading, learning, first_pass, later_pass, writing };

/// @return the answer, which is never destroyed.
const InterruptAnswer& answer_while(RenderStep step, const RenderOptions& options);

}  // namespace sunfleck::engine
