// File identities by stat() and readlink().
#include "core/file_identity.h"

#include "sunfleck/error.h"

#include <sys/stat.h>

#include <filesystem>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

/// The system's own limit of links in a chain.
constexpr int kMostLinks = 40;

std::optional<FileIdentity> existing(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return FileIdentity{status.st_dev, status.st_ino, ""};
}

}  // namespace

std::string link_target(const std::string& path) {
    fs::path at = path;
    for (int step = 0; step < kMostLinks; ++step) {
        std::error_code code;
        const fs::path next = fs::read_symlink(at, code);
        if (code) {
            // The system's own links (/proc/self/fd/3) may lead to what their text does not name.
            if (step > 0 && existing(path) != existing(at.string()))
                throw Error({path}, "leads to a deleted file that has no name",
                            "name another file");
            return at.string();
        }
        at = at.parent_path() / next;
    }
    throw Error({path}, "is a link that leads back to itself", "name a file");
}

std::optional<FileIdentity> identity_of(const std::string& path) {
    if (path.empty()) return {};
    if (auto found = existing(path)) return found;
    const fs::path target = link_target(path);
    const fs::path folder = target.parent_path();
    auto parent = existing(folder.empty() ? "." : folder.string());
    if (parent) parent->new_name = target.filename().string();
    return parent;
}

}  // namespace sunfleck::engine
