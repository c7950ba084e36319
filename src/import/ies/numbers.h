// Numbers of an IES file: separated by blanks, commas and ends of lines.
#pragma once

#include "sunfleck/error.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

class IesNumbers {
public:
    /// @param begin  first byte of the numbers; text and name must outlive this.
    IesNumbers(std::string_view text, std::size_t begin, const std::string& name)
        : text_(text), name_(name), at_(begin) {}

    /// @param what  completes the message: expected `what`. @throws Error  unless a finite number
    /// is next.
    double next(const std::string& what);
    /// Returns the next number as a count. @throws Error  unless it is a whole number of 1 or more,
    /// and as many numbers can follow.
    std::size_t count(const std::string& what);

    /// Refuses the number that was read last.
    [[noreturn]] void refuse(const std::string& what, const std::string& mend) const;

private:
    SourceLocation location() const;

    std::string_view text_;
    const std::string& name_;
    std::size_t at_;
    std::size_t last_ = 0;  // where the last number begins
};

}  // namespace sunfleck::engine
