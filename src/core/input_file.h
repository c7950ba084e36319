// Input files: whole as bytes, for the readers that parse in memory, or open to be read in pieces.
#pragma once

#include "sunfleck/error.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace sunfleck::engine {

/// A file that is not there, or not under that very name.
class MissingFile : public Error {
public:
    /// @param from  the statement that names it.
    /// @param mend  what to do: for example, which file there is instead.
    MissingFile(const SourceLocation& from, const std::string& path, const std::string& mend);

    const std::string& path() const { return path_; }
    const std::string& mend() const { return mend_; }
    /// Path, place, and what there is instead: for a list of missing files.
    std::string line() const;

private:
    std::string path_;
    std::string mend_;
};

/// A regular file, open at its first byte.
struct OpenFile {
    std::ifstream stream;
    std::uintmax_t size = 0;  // bytes
};

/// @param from  the statement that names it: the place of the error if it cannot be opened.
/// @throws MissingFile  if there is none; its remedy names a file that differs in case alone.
/// @throws Error  for folders, pipes, devices, and what cannot be opened.
OpenFile open_input_file(const std::string& path, const SourceLocation& from);

/// The bytes of a regular file.
/// @throws Error  as open_input_file(), and for what cannot be read or held in memory.
std::string read_input_file(const std::string& path, const SourceLocation& from);

/// All of standard input. @param name  of it, for messages. @throws Error  beyond free memory.
std::string read_standard_input(const std::string& name);

}  // namespace sunfleck::engine
