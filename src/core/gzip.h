// Unpacks gzip files, known by their content and not by their name.
#pragma once

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Do the bytes begin as a gzip file does (RFC 1952)?
inline bool is_gzip(std::string_view bytes) {
    return bytes.substr(0, 2) == "\x1f\x8b";
}

/// What the gzip file holds, all members joined; bytes after the last member are ignored.
/// @param name  of the file, for errors.
/// @throws Error for a cut or damaged file, and for one that unpacks to more than half of the
///         memory that is free.
std::string gunzip(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine
