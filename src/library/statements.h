// Calls of the interface as statements of the importer.
#pragma once

#include "import/pbrt/parameters.h"
#include "sunfleck/parameters.h"

#include <string>

namespace sunfleck {

/// Returns a statement such as Shape "sphere".
/// @param where  the call's name in messages: shape 3.
/// @throws Error  for declarations and values that do not fit each other.
engine::Statement statement_of(const std::string& keyword, const std::string& type,
                               const Parameters& parameters, const std::string& where);

}  // namespace sunfleck
