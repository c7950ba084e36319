// Input files: read whole into memory, or opened as a stream.
#pragma once

#include "sunfleck/error.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace sunfleck::engine {

/// Error for a file that does not exist under exactly that name.
class MissingFile : public Error {
public:
    /// @param from  statement that names the file.
    /// @param mend  remedy: for example, the name of a similar file that exists.
    MissingFile(const SourceLocation& from, const std::string& path, const std::string& mend);

    const std::string& path() const { return path_; }
    const std::string& mend() const { return mend_; }
    /// Returns path, location and remedy on one line, for a list of missing files.
    std::string line() const;

private:
    std::string path_;
    std::string mend_;
};

/// A regular file, opened at its first byte.
struct OpenFile {
    std::ifstream stream;
    std::uintmax_t size = 0;  // bytes
};

/// Opens a regular file.
/// @param from  statement that names the file; the location of errors.
/// @throws MissingFile  if it does not exist; the remedy names a file that differs in case alone.
/// @throws Error  for folders, pipes, devices, and files that cannot be opened.
OpenFile open_input_file(const std::string& path, const SourceLocation& from);

/// Reads a regular file into memory.
/// @throws Error  as open_input_file(), and for a file that cannot be read or does not fit in
/// memory.
std::string read_input_file(const std::string& path, const SourceLocation& from);

/// Reads all of standard input. @param name  its name in messages.
/// @throws Error  if the text exceeds free memory.
std::string read_standard_input(const std::string& name);

}  // namespace sunfleck::engine
