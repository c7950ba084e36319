// Manifest: the names of a matte and their IDs, and what an .exr says of it.
//
// Source: Cryptomatte Specification 1.2.0, "Metadata" and "Manifest".
#pragma once

#include "mattes/matte_id.h"

#include <map>
#include <string>

namespace sunfleck::engine {

/// Names of a matte, in UTF-8, and their IDs.
using Manifest = std::map<std::string, MatteId>;

/// Returns the manifest as a JSON object, its names in order.
std::string manifest_json(const Manifest& manifest);

/// Returns the attributes of the .exr that describe a matte: cryptomatte/KEY/name and so on.
/// @param layer  "CryptoObject". Its hash is the key.
std::map<std::string, std::string> matte_metadata(const std::string& layer,
                                                  const Manifest& manifest);

}  // namespace sunfleck::engine
