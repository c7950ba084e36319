// Reads a complete file as bytes, for parsers that work in memory.
#pragma once

#include "core/input_file.h"

#include <string>

namespace sunfleck::engine {

/// @throws Error  if the file does not exist or cannot be read.
inline std::string read_file(const std::string& path) {
    return read_input_file(path, {path});
}

}  // namespace sunfleck::engine
