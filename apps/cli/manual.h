// Man pages and completion files of a system, in folders as they stand below /usr/share.
#pragma once

#include "apps/cli/command_tree.h"

namespace sunfleck::engine {

/// Writes man/man1/*.1 and the completion file of each shell.
/// @throws Error for a folder that cannot be written to.
void write_manual(const Command& program, const std::string& folder);

}  // namespace sunfleck::engine
