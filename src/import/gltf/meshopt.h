// EXT_meshopt_compression: buffer views that meshoptimizer has packed.
//
// Built in where CMake finds meshoptimizer (SUNFLECK_MESHOPT).
#pragma once

#include "import/gltf/json_place.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns whether this program can unpack them.
bool has_meshopt();

/// Returns the unpacked bytes of a buffer view.
/// @param extension  of the buffer view. @param packed  the bytes that it names.
/// @throws Error  for damaged data. Not called without meshoptimizer.
std::string unpack_meshopt(const JsonPlace& extension, std::string_view packed);

}  // namespace sunfleck::engine
