// Access to the files that a scene names.
#pragma once

#include "core/input_file.h"

#include <functional>
#include <string>

namespace sunfleck::engine {

/// Returns the bytes of a file, decompressed if it is gzip.
/// @param from  statement that names it.
/// @throws MissingFile  if it does not exist.
/// @throws Error  if it cannot be read.
using FileAccess = std::function<std::string(const std::string& path, const SourceLocation& from)>;

/// Decompresses the bytes if they are gzip. @param name  file name for messages.
std::string unpacked(std::string bytes, const std::string& name);

/// Returns access to the disk.
FileAccess disk_access();

/// The name of standard input in messages.
inline constexpr std::string_view kStandardInput = "standard input";

/// A file that a scene names.
struct NamedFile {
    std::string path;  // where it was found
    std::string bytes;
    bool by_slashes = false;  // its name has backslashes, which were read as slashes
};

/// Finds and reads a file that a scene names. If no file has the name, backslashes count as
/// slashes. Thread-safe.
/// @throws MissingFile, Error  like `files`, and for an empty name.
NamedFile find_file(const std::string& name, const std::string& folder, const SourceLocation& from,
                    const FileAccess& files);

/// Returns the path of a file named in a scene: relative names start at the main file's folder.
std::string resolved(const std::string& name, const std::string& folder);

}  // namespace sunfleck::engine
