// Durations as people read them.
#pragma once

#include <string>

namespace sunfleck::engine {

/// In whole seconds: 7 s, 3m12s, 2h05m.
std::string duration_text(double seconds);

}  // namespace sunfleck::engine
