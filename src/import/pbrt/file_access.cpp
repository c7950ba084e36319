// Files that a scene names: found beside the main file, unpacked by content.
#include "import/pbrt/file_access.h"

#include "core/gzip.h"
#include "core/input_file.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

/// Replaces backslashes by slashes. A backslash before n, r, t, b or f was read as the escape of a
/// control character, which no file name has.
std::string with_slashes(const std::string& name) {
    constexpr std::string_view kControls = "\n\r\t\b\f";
    constexpr std::string_view kLetters = "nrtbf";
    std::string result;
    for (const char c : name) {
        const std::size_t escape = kControls.find(c);
        if (c == '\\' || escape != std::string_view::npos)
            result += '/';
        else
            result += c;
        if (escape != std::string_view::npos) result += kLetters[escape];
    }
    return result;
}

}  // namespace

std::string unpacked(std::string bytes, const std::string& name) {
    if (!is_gzip(bytes)) return bytes;
    return gunzip(bytes, name);
}

FileAccess disk_access() {
    return [](const std::string& path, const SourceLocation& from) {
        return unpacked(read_input_file(path, from), path);
    };
}

NamedFile find_file(const std::string& name, const std::string& folder, const SourceLocation& from,
                    const FileAccess& files) {
    if (name.empty()) throw Error(from, "the name of a file is empty", "give the name of the file");
    const std::string path = resolved(name, folder);
    const std::string slashed = resolved(with_slashes(name), folder);
    try {
        return {path, files(path, from)};
    } catch (const MissingFile&) {
        if (slashed == path) throw;
    }
    try {
        return {slashed, files(slashed, from), true};
    } catch (const MissingFile& missing) {
        throw MissingFile(from, path, missing.mend());
    }
}

std::string resolved(const std::string& name, const std::string& folder) {
    const std::filesystem::path path(name);
    if (path.is_absolute() || folder.empty()) return path.lexically_normal().string();
    return (std::filesystem::path(folder) / path).lexically_normal().string();
}

}  // namespace sunfleck::engine
