// OpenEXR files: named channels of 32-bit or 16-bit floats, and text metadata.
#pragma once

#include "image/picture.h"

#include <cstddef>
#include <string>

namespace sunfleck::engine {

struct ExrOptions {
    bool half = false;  // 16-bit floats: half the size, 3 digits, at most 65504
};

/// Writes all channels and the metadata atomically; the same input gives the same bytes. With
/// `half`, finite values beyond 65504 are clamped to +-65504.
/// @param picture  at least one pixel and one channel; channel names are distinct.
/// @throws Error  if the file cannot be written.
void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options = {});

/// Returns the bytes of the file that write_exr() writes.
std::string exr_bytes(const Picture& picture, const ExrOptions& options = {});

/// Reads all channels of the first part as floats, in the data window, and the text metadata.
/// @throws Error  for what is not EXR, is truncated or damaged, is deep or has subsampled channels,
/// or claims more values than the file can hold.
Picture read_exr(const std::string& path);

}  // namespace sunfleck::engine
