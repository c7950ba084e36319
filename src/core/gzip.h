// Decompression of gzip files, which are recognised by content and not by name.
#pragma once

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns whether the bytes begin like a gzip file (RFC 1952).
inline bool is_gzip(std::string_view bytes) {
    return bytes.substr(0, 2) == "\x1f\x8b";
}

/// Returns the decompressed content of all members; bytes after the last member are ignored.
/// @param name  file name for errors.
/// @throws Error  for a truncated or damaged file, and for one that unpacks to more than half of
/// the free memory.
std::string gunzip(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
