// The one error of the project: a user's input that cannot be used, and what to do about it.
//
// Thrown where the fault is seen, caught once per program (apps/*/main.cpp prints it, exit code 2).
// A fault of ours is not an Error: it is an assert, or a test that is missing.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace sunfleck {

/// A place in a scene file. Lines and columns count from 1; 0 means "the file as a whole".
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    /// file, or file:line:column.
    std::string text() const {
        if (line == 0) return file;
        return file + ":" + std::to_string(line) + ":" + std::to_string(column);
    }
};

class Error : public std::runtime_error {
public:
    /// @param what  what is wrong, naming the user's own words: unknown material "glas"
    /// @param mend  what would be right: use "dielectric", or one of "conductor", "diffuse"
    Error(SourceLocation where, const std::string& what, const std::string& mend)
        : std::runtime_error(where.text() + ": " + what + "; " + mend), where_(std::move(where)) {}

    const SourceLocation& where() const { return where_; }

    /// The same fault of a data file, told with the statement that asked for the file.
    Error asked_for_at(const SourceLocation& from) const {
        return Error(where_, std::string(what()) + " (asked for at " + from.text() + ")");
    }

protected:
    /// @param whole  message that says what is wrong and how to mend it.
    Error(SourceLocation where, const std::string& whole)
        : std::runtime_error(whole), where_(std::move(where)) {}

private:
    SourceLocation where_;
};

}  // namespace sunfleck
