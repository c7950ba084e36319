// Headers of OpenEXR files that are written: channels, colour space, texts, date.
#pragma once

#include "image/exr_layers.h"
#include "image/exr_options.h"
#include "image/picture.h"

#include <OpenEXR/ImfHeader.h>

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns whether a layer has 16-bit floats. IDs never have them.
bool is_half(const ExrLayer& layer, const ExrOptions& options);

/// Returns a header without channels or metadata: size, shape of pixels, colour space, compression.
Imf::Header plain_exr_header(const Picture& picture, const ExrOptions& options);

void insert_channels(Imf::Header& header, const ExrLayer& layer, const ExrOptions& options);

/// Returns the date in SOURCE_DATE_EPOCH as OpenEXR writes dates; nothing if there is none.
/// @throws Error  if it holds something else than seconds up to the year 9999.
std::optional<std::string> exr_date();

/// Adds the texts of the picture, and the date if SOURCE_DATE_EPOCH holds one.
void insert_metadata(Imf::Header& header, const Picture& picture);

}  // namespace sunfleck::engine
