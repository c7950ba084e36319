// OpenEXR files: any number of named channels of 32-bit or 16-bit floats, with text beside them.
#pragma once

#include "image/picture.h"

#include <cstddef>
#include <string>

namespace sunfleck::engine {

struct ExrOptions {
    bool half = false;  // 16-bit floats: half the size, 3 digits, at most 65504
};

/// Writes all channels and the metadata, atomically and with the same bytes each time.
/// With `half`, finite values beyond 65504 are written as +-65504.
/// @param picture  at least one pixel and one channel, names distinct.
/// @throws Error if the file cannot be written.
void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options = {});

/// Reads all channels of the first part as floats, in the data window alone, and the texts.
/// @throws Error for what is no EXR, is cut or damaged, is deep or has subsampled channels, or
///         claims more values than its size can hold.
Picture read_exr(const std::string& path);

}  // namespace sunfleck::engine
