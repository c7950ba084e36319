// OpenEXR files: named channels of 32-bit or 16-bit floats, and text metadata.
//
// What is written is scene light in linear sRGB (Rec. 709 primaries, white D65), and says so. It
// has no date, so that the same picture gives the same bytes, unless the environment variable
// SOURCE_DATE_EPOCH holds one (seconds since 1970, reproducible-builds.org): then the attribute
// `capDate` is that moment in UTC.
#pragma once

#include "image/exr_options.h"
#include "image/picture.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Writes all channels and the metadata atomically; the same input gives the same bytes. In 16-bit
/// floats, finite values beyond 65504 are clamped to +-65504.
/// @param picture  at least one pixel and one channel; channel names are distinct.
/// @throws Error  if the file cannot be written, as check_exr_date() does, or for a compression
/// that would change IDs (id_layers.h). These have 32-bit floats in any case.
void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options = {});

/// Returns the bytes of the file that write_exr() writes.
std::string exr_bytes(const Picture& picture, const ExrOptions& options = {});

/// @throws Error  if SOURCE_DATE_EPOCH holds something else than seconds up to the year 9999.
void check_exr_date();

/// Reads all channels of all parts as floats, in the data window, and the text metadata of the
/// first part. A channel whose name another part has, too, is read as PART.NAME.
/// @throws Error  for what is not EXR, is truncated or damaged, has deep pixels, subsampled
/// channels or parts of several sizes, or claims more values than the file can hold.
Picture read_exr(const std::string& path);

/// Reads a file in memory. @param name  file name for messages.
Picture parse_exr(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
