// Which file a name leads to, so that one file is known under all of its names.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace sunfleck::engine {

/// Device and inode of a file. Of a file that is yet to be made: those of its folder, and its name.
struct FileIdentity {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::string new_name;  // empty for a file that is there

    auto operator<=>(const FileIdentity&) const = default;
};

/// @return  nothing where neither the file nor its folder is there.
std::optional<FileIdentity> identity_of(const std::string& path);

/// The end of a chain of symbolic links, whether it is there or not; else the path itself.
/// @throws Error for links that lead back to themselves, or to a file that has no name any more.
std::string link_target(const std::string& path);

}  // namespace sunfleck::engine
