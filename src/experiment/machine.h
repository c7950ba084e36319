// Description of the machine on which figures were measured.
#pragma once

#include <string>

namespace sunfleck::engine {

/// Returns the processor's name and the number of threads that this process may use.
std::string machine_text();

}  // namespace sunfleck::engine
