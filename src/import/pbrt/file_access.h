// How the reader reaches other files than the one it was given.
#pragma once

#include "core/error.h"

#include <functional>
#include <string>

namespace sunfleck {

/// The bytes of a file, unpacked if it is a gzip file.
/// @param from  the statement that names it. @throws Error if it cannot be read.
using FileAccess = std::function<std::string(const std::string& path, const SourceLocation& from)>;

/// Reads from the disk.
FileAccess disk_access();

/// Refuses every file: for text that is not trusted.
FileAccess no_access();

/// A file named in a scene: relative names start at the folder of the main file.
std::string resolved(const std::string& name, const std::string& folder);

}  // namespace sunfleck
