// The bytes of a render: the same with one thread and with two, and after an interrupt.
#pragma once

#include "differential/renders.h"

#include <optional>

namespace sunfleck::engine::differential {

/// @throws RenderFault for a render that fails.
std::optional<Fault> check_bytes(Renders& renders);

}  // namespace sunfleck::engine::differential
