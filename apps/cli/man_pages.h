// Man pages, section 1: one of the program and one of each of its commands.
#pragma once

#include "apps/cli/command_tree.h"

namespace sunfleck::engine {

/// The page sunfleck(1), in roff.
std::string man_page(const Command& program);

/// The page of a command, sunfleck-NAME(1). @param command  one of the program's.
std::string man_page(const Command& program, const Command& command);

}  // namespace sunfleck::engine
