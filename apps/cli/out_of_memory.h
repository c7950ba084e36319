// The exception of `new` in this program, with the number of bytes that could not be allocated.
#pragma once

#include <array>
#include <cstddef>
#include <new>

namespace sunfleck::engine {

/// Thrown by `new` in this program.
class OutOfMemory : public std::bad_alloc {
public:
    explicit OutOfMemory(std::size_t bytes) noexcept;
    /// One line: how much was asked for, and how to need less.
    const char* what() const noexcept override { return text_.data(); }

private:
    std::array<char, 200> text_{};
};

}  // namespace sunfleck::engine
