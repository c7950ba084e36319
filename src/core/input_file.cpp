// Input files by the C++ library; the file system tells the type of a path.
#include "core/input_file.h"

#include "core/memory_room.h"
#include "core/small_letters.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCheckName = "check the name";

/// Quotes a path on one line, with control characters as escapes.
std::string in_one_line(const std::string& path) {
    constexpr std::size_t kMost = 4096;
    constexpr std::string_view kControls = "\n\r\t\b\f";
    constexpr std::string_view kLetters = "nrtbf";
    std::string shown = "\"";
    for (const char c : path.substr(0, kMost)) {
        const std::size_t escape = kControls.find(c);
        if (escape != std::string_view::npos)
            shown += std::string("\\") + kLetters[escape];
        else
            shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    }
    return shown + '"';
}

/// Returns the alphabetically first entry of a folder whose name satisfies a test.
template <class IsLike>
std::optional<fs::path> entry_like(const fs::path& folder, const IsLike& is_like) {
    std::error_code code;
    std::optional<fs::path> found;
    const fs::path shown = folder.empty() ? fs::path(".") : folder;
    for (fs::directory_iterator entry(shown, code), end; !code && entry != end;
         entry.increment(code)) {
        const fs::path name = entry->path().filename();
        if (is_like(name) && (!found || name < found->filename())) found = folder / name;
    }
    return found;
}

/// Returns the entry of a folder that differs from `name` in case alone.
std::optional<fs::path> entry_of_other_case(const fs::path& folder, const std::string& name) {
    const std::string wanted = small_letters(name);
    return entry_like(
        folder, [&](const fs::path& entry) { return small_letters(entry.string()) == wanted; });
}

/// Returns a file with the same stem: another ending, none, or trailing blanks.
std::optional<fs::path> path_of_other_ending(const fs::path& path) {
    const std::string wanted = small_letters(path.stem().string());
    return entry_like(path.parent_path(), [&](const fs::path& entry) {
        return small_letters(entry.stem().string()) == wanted;
    });
}

/// Returns a remark for paths of another system, "C:/a.png" or "https:/b.org/a.png"; else empty.
std::string_view foreign_name(std::string_view path) {
    const std::size_t colon = path.find(":/");
    if (colon == std::string_view::npos) return "";
    const std::size_t folder = path.substr(0, colon).rfind('/');
    const std::size_t begin = folder == std::string_view::npos ? 0 : folder + 1;
    const bool is_word =
        std::all_of(path.begin() + static_cast<int>(begin), path.begin() + static_cast<int>(colon),
                    [](unsigned char c) { return std::isalpha(c) != 0; });
    if (!is_word || colon == begin) return "";
    return colon - begin == 1 ? "it is on a drive of Windows: name the file relative to the scene"
                              : "it is an address: download the file and name the copy";
}

/// Returns the file whose path differs in case alone, or nothing.
std::optional<fs::path> path_of_other_case(const fs::path& path) {
    fs::path found;
    std::error_code code;
    for (const fs::path& part : path) {
        if (fs::exists(found / part, code)) {
            found /= part;
            continue;
        }
        const auto entry = entry_of_other_case(found, part.string());
        if (!entry) return std::nullopt;
        found = *entry;
    }
    return found;
}

[[noreturn]] void missing(const std::string& path, const SourceLocation& from) {
    std::error_code code;
    if (fs::is_symlink(fs::symlink_status(path, code)))
        throw MissingFile(from, path,
                          "it is a link to " + in_one_line(fs::read_symlink(path, code).string()) +
                              ", which does not exist");
    if (const auto other = path_of_other_case(path))
        throw MissingFile(
            from, path,
            "there is " + in_one_line(other->string()) + ": check upper and lower case");
    if (const auto other = path_of_other_ending(path))
        throw MissingFile(from, path, "there is " + in_one_line(other->string()));
    const std::string_view foreign = foreign_name(path);
    throw MissingFile(from, path, std::string(foreign.empty() ? kCheckName : foreign));
}

/// Throws if the path is not a regular file.
void check_kind(const std::string& path, const SourceLocation& from) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    const std::string quoted = in_one_line(path);
    switch (status.type()) {
        case fs::file_type::regular:
            return;
        case fs::file_type::not_found:
            missing(path, from);
        case fs::file_type::directory:
            throw Error(from, quoted + " is a folder", "name a file in it");
        case fs::file_type::fifo:
            throw Error(from, quoted + " is a pipe, and files are read more than once",
                        "write it to a file; a scene may come from standard input, as -");
        case fs::file_type::none:
        case fs::file_type::unknown:
            throw Error(from, quoted + " cannot be reached: " + code.message(),
                        "check that you may read it");
        default:
            throw Error(from, quoted + " is a device or a socket, not a file",
                        "name a regular file");
    }
}

[[noreturn]] void too_large(std::uintmax_t size, const std::string& what,
                            const SourceLocation& from) {
    constexpr std::uintmax_t kMebi = 1U << 20U;
    throw Error(from,
                what + " of " + std::to_string(size / kMebi) +
                    " MiB is larger than the memory that is free",
                "free some, or use a smaller file");
}

}  // namespace

MissingFile::MissingFile(const SourceLocation& from, const std::string& path,
                         const std::string& mend)
    : Error(from, "there is no file " + in_one_line(path), mend), path_(path), mend_(mend) {}

std::string MissingFile::line() const {
    return in_one_line(path_) + " (" + where().text() + ")" +
           (mend_ == kCheckName ? "" : ": " + mend_);
}

OpenFile open_input_file(const std::string& path, const SourceLocation& from) {
    check_kind(path, from);
    std::error_code code;
    const std::uintmax_t size = fs::file_size(path, code);
    std::ifstream stream(path, std::ios::binary);
    if (!code && !stream) code.assign(errno, std::generic_category());
    if (code)
        throw Error(from, in_one_line(path) + " cannot be opened: " + code.message(),
                    "check that you may read it");
    return {std::move(stream), size};
}

std::string read_input_file(const std::string& path, const SourceLocation& from) {
    auto [stream, size] = open_input_file(path, from);
    const std::string quoted = in_one_line(path);
    constexpr std::uintmax_t kSmall = 1U << 24U;  // smaller files are read without asking
    if (size > kSmall && size > free_memory()) too_large(size, quoted, from);
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size)
        throw Error(from, quoted + " cannot be read to its end", "check the disk");
    return bytes;
}

std::string read_standard_input(const std::string& name) {
    constexpr std::size_t kPiece = std::size_t{1} << 20U;
    std::string bytes;
    for (std::size_t filled = 0;;) {
        bytes.resize(filled + kPiece);
        const std::size_t count = std::fread(bytes.data() + filled, 1, kPiece, stdin);
        filled += count;
        bytes.resize(filled);
        if (count < kPiece) break;
        // The text grows by doubling, so the same amount again must be free.
        if (filled > free_memory()) too_large(filled, "the text", {name});
    }
    if (std::ferror(stdin) != 0) throw Error({name}, "cannot be read to its end", "try again");
    return bytes;
}

}  // namespace sunfleck::engine
