// How much memory there is for this process, and what limits it.
#pragma once

#include <cstdint>
#include <string>

namespace sunfleck::engine {

/// Bytes of memory that this process has; zero where the system does not say.
std::uint64_t memory_in_use();

/// The most that it has had at once.
std::uint64_t most_memory_in_use();

struct MemoryRoom {
    std::uint64_t bytes = 0;  // that this process may have in all; no limit is the largest number
    std::string limit;        // what sets it
};

/// The least of what is free on the machine, what its control group (version 1 or 2, and all that
/// hold it) leaves, and the limit of address space.
/// @param root  the folder that holds proc/ and sys/, for tests.
MemoryRoom memory_room(const std::string& root = "");

/// Bytes that this process may still ask for: what its room leaves beside what it uses.
std::uint64_t free_memory();

/// "1.5 GiB", "230 MiB".
std::string memory_text(std::uint64_t bytes);

}  // namespace sunfleck::engine
