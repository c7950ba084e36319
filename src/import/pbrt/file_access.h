// How the reader reaches other files than the one it was given.
#pragma once

#include "core/input_file.h"

#include <functional>
#include <string>

namespace sunfleck::engine {

/// The bytes of a file, unpacked if it is a gzip file.
/// @param from  the statement that names it. @throws MissingFile if there is none, Error if it
/// cannot be read.
using FileAccess = std::function<std::string(const std::string& path, const SourceLocation& from)>;

/// The bytes, unpacked if they are a gzip file. @param name  of it, for messages.
std::string unpacked(std::string bytes, const std::string& name);

/// Reads from the disk.
FileAccess disk_access();

/// The name of standard input, as messages tell it.
inline constexpr std::string_view kStandardInput = "standard input";

/// A file that a scene names.
struct NamedFile {
    std::string path;  // where it was found
    std::string bytes;
    bool by_slashes = false;  // its name has backslashes, read as slashes
};

/// Finds and reads a file that a scene names; a backslash in the name of no file counts as a slash.
/// Any number of threads may call it at a time.
/// @throws MissingFile, Error  as `files` does.
NamedFile find_file(const std::string& name, const std::string& folder, const SourceLocation& from,
                    const FileAccess& files);

/// A file named in a scene: relative names start at the folder of the main file.
std::string resolved(const std::string& name, const std::string& folder);

}  // namespace sunfleck::engine
