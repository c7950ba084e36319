// Identity of files: device and inode, so that one file is recognised under all its names.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace sunfleck::engine {

/// Device and inode of a file; for a file that does not exist yet, those of its folder, and its
/// name.
struct FileIdentity {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::string new_name;  // empty for a file that exists

    // NOLINTNEXTLINE(modernize-use-nullptr): seen in code that the compiler writes
    auto operator<=>(const FileIdentity&) const = default;
};

/// Returns the identity, or nothing if neither the file nor its folder exists.
std::optional<FileIdentity> identity_of(const std::string& path);

/// Returns the end of a chain of symbolic links, whether it exists or not; else the path itself.
/// @throws Error  for a cycle of links, and for a link to a file that has no name any more.
std::string link_target(const std::string& path);

}  // namespace sunfleck::engine
