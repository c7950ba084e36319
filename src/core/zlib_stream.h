// Decompression of zlib streams (RFC 1950), of which the unpacked size is known.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns the decompressed bytes, or nothing if the stream is damaged or not of that size.
/// @param size  of the bytes when unpacked.
std::optional<std::string> inflated(std::string_view stream, std::size_t size);

}  // namespace sunfleck::engine
