// Layers of a picture whose values are IDs: those of Cryptomattes.
#pragma once

#include "image/exr_options.h"
#include "image/picture.h"

#include <string>

namespace sunfleck::engine {

/// Returns whether a layer belongs to a Cryptomatte of the picture, as its attributes tell
/// ("cryptomatte/KEY/name"). The bits of its values count: they must not be rounded.
bool holds_ids(const Picture& picture, const std::string& layer);

/// @throws Error  for a picture with such a layer and a compression that would change its values.
void check_ids_kept(const Picture& picture, const ExrOptions& options);

/// Returns whether values of light and of IDs alike come back from a file as they were.
bool is_exact(ExrCompression compression);

}  // namespace sunfleck::engine
