// Memory available to this process, and what limits it.
#pragma once

#include <cstdint>
#include <string>

namespace sunfleck::engine {

/// Returns the resident memory of this process in bytes; zero where the system does not tell.
std::uint64_t memory_in_use();

/// Returns the peak of memory_in_use() since the process began.
std::uint64_t most_memory_in_use();

struct MemoryRoom {
    std::uint64_t bytes = 0;  // the most that this process may use; the largest number if unlimited
    std::string limit;        // name of the limit, for messages
};

/// Returns the smallest of the machine's free memory, the limit of the control group (version 1 or
/// 2, with all its parents), and the limit of address space.
/// @param root  folder that holds proc/ and sys/, for tests.
MemoryRoom memory_room(const std::string& root = "");

/// Returns the bytes that this process may still allocate.
std::uint64_t free_memory();

/// Formats bytes with a unit: "1.5 GiB", "230 MiB".
std::string memory_text(std::uint64_t bytes);

}  // namespace sunfleck::engine
