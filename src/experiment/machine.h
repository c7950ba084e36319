// What the figures were measured on.
#pragma once

#include <string>

namespace sunfleck::engine {

/// The processor's name and how many of its threads this process may use.
std::string machine_text();

}  // namespace sunfleck::engine
