// A whole file as bytes, for the readers that parse in memory.
#pragma once

#include "core/input_file.h"

#include <string>

namespace sunfleck::engine {

/// @throws Error if there is no such file, or it cannot be read.
inline std::string read_file(const std::string& path) {
    return read_input_file(path, {path});
}

}  // namespace sunfleck::engine
