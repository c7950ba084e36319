// The command line: reads the words of a user into options. Each flag has its row in
// command_line.cpp or *_options.cpp.
#pragma once

#include "apps/cli/options.h"

#include <optional>

namespace sunfleck::engine {

/// Reads the command line. @return nothing when all has been said (--help, --version): exit 0.
/// @throws Error with place "sunfleck" or the flag for anything that cannot be used.
std::optional<Options> read_options(int count, const char* const* words);

}  // namespace sunfleck::engine
