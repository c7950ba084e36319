// The one error of the library and its programs: what cannot be used or done, and how to mend it.
//
// It is thrown where the fault is seen. A fault of Sunfleck's own is not an Error: it is an assert,
// or a test that is missing.
#pragma once

#include <sunfleck/export.h>

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

/// Who can mend an Error.
enum class ErrorCode {
    input,   // the user: a scene, a file, a setting or a call is wrong
    machine  // whoever runs the machine: no memory, no thread, no room on the disk
};

/// Its what() is one line: where, what is wrong, how to mend it.
class SUNFLECK_API Error : public std::runtime_error {
public:
    /// @param where  a place in a file, or the name of a setting or of a call.
    /// @param what   what is wrong, naming the user's own words: unknown material "glas"
    /// @param mend   what would be right: use "dielectric", or one of "conductor", "diffuse"
    Error(SourceLocation where, const std::string& what, const std::string& mend,
          ErrorCode code = ErrorCode::input)
        : Error(where, where.text() + ": " + what + "; " + mend, code) {}

    const SourceLocation& where() const { return where_; }
    ErrorCode code() const { return code_; }

    /// The same fault of a data file, told with the statement that asked for the file.
    Error asked_for_at(const SourceLocation& from) const {
        return Error(where_, std::string(what()) + " (asked for at " + from.text() + ")", code_);
    }

protected:
    /// @param whole  message that says what is wrong and how to mend it.
    Error(SourceLocation where, const std::string& whole, ErrorCode code)
        : std::runtime_error(whole), where_(std::move(where)), code_(code) {}

private:
    SourceLocation where_;
    ErrorCode code_;
};

}  // namespace sunfleck
