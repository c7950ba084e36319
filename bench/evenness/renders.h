// Renders by child processes, each in a folder of its own; finished ones are never rendered again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine::bench {

/// A program and the flags that it gets for `render`.
struct Method {
    std::string name;
    std::string program;
    std::vector<std::string> flags;
};

struct Render {
    std::string folder;  // its own
    std::string scene_file;
    Method method;
    std::uint64_t seed = 0;
    double cpu_seconds = 60;
    int resolution = 256;

    bool is_done() const;
    std::string picture() const { return folder + "/picture.exr"; }
    /// Returns the processor time that it took.
    double taken() const;
};

/// Renders what is not done yet, in the order of the list, so many at once, each by one thread.
/// @throws Error  with the last line that a render said, if it fails.
void make_renders(const std::vector<Render>& renders, std::size_t at_once);

}  // namespace sunfleck::engine::bench
