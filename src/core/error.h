// Error: input that cannot be used, and how the user can mend it.
//
// An Error is thrown where the fault is found and caught once per program (apps/*/main.cpp prints
// it; exit code 2). A fault of the program itself is no Error but a failed assert.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace sunfleck {

/// A position in a scene file. Lines and columns count from 1; line 0 stands for the whole file.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    /// Returns "file:line:column", or "file" alone where the line is 0.
    std::string text() const {
        if (line == 0) return file;
        return file + ":" + std::to_string(line) + ":" + std::to_string(column);
    }
};

class Error : public std::runtime_error {
public:
    /// @param what  what is wrong, in the user's own words: unknown material "glas"
    /// @param mend  how to mend it: use "dielectric", or one of "conductor", "diffuse"
    Error(SourceLocation where, const std::string& what, const std::string& mend)
        : std::runtime_error(where.text() + ": " + what + "; " + mend), where_(std::move(where)) {}

    const SourceLocation& where() const { return where_; }

    /// Returns the same error of a data file with the statement that named the file.
    Error asked_for_at(const SourceLocation& from) const {
        return Error(where_, std::string(what()) + " (asked for at " + from.text() + ")");
    }

protected:
    /// @param whole  the complete message: what is wrong, and how to mend it.
    Error(SourceLocation where, const std::string& whole)
        : std::runtime_error(whole), where_(std::move(where)) {}

private:
    SourceLocation where_;
};

}  // namespace sunfleck
