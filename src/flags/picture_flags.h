// The flags of every way of rendering: ends, picture, light paths, random numbers.
#pragma once

#include "flags/flag.h"

namespace sunfleck {

/// Ends of a render: passes, time, error.
std::vector<RenderFlag> end_flags();

/// Size, crop, exposure, AOVs, and whether bias is subtracted.
std::vector<RenderFlag> picture_flags();

/// Which light paths there are, with every integrator.
std::vector<RenderFlag> transport_flags();

/// Random numbers and instructions.
std::vector<RenderFlag> run_flags();

}  // namespace sunfleck
