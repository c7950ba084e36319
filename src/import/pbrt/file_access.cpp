// Files that a scene names: found beside the main file, unpacked by content.
#include "import/pbrt/file_access.h"

#include "import/pbrt/ply_gzip.h"
#include "import/pbrt/words.h"

#include <filesystem>
#include <fstream>

namespace sunfleck {
namespace {

constexpr std::size_t kLongestPath = 4096;

std::string bytes_of(const std::string& path, const SourceLocation& from) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code))
        throw Error(from, "there is no file " + in_quotes(path, kLongestPath), "check the name");
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    if (code || !file)
        throw Error(from, in_quotes(path, kLongestPath) + " cannot be opened",
                    "check that you may read it");
    std::string bytes(size, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size)
        throw Error(from, in_quotes(path, kLongestPath) + " cannot be read to its end",
                    "check the disk");
    return bytes;
}

}  // namespace

FileAccess disk_access() {
    return [](const std::string& path, const SourceLocation& from) {
        std::string bytes = bytes_of(path, from);
        return is_gzip(bytes) ? gunzip(bytes, path) : bytes;
    };
}

FileAccess no_access() {
    return [](const std::string& path, const SourceLocation& from) -> std::string {
        throw Error(from, "other files are not read here: " + in_quotes(path, kLongestPath),
                    "leave them out");
    };
}

std::string resolved(const std::string& name, const std::string& folder) {
    const std::filesystem::path path(name);
    if (path.is_absolute() || folder.empty()) return path.lexically_normal().string();
    return (std::filesystem::path(folder) / path).lexically_normal().string();
}

}  // namespace sunfleck
