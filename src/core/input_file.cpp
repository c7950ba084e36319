// Input files by the C++ library; what kind of thing a name stands for by the file system.
#include "core/input_file.h"

#include "core/memory_room.h"
#include "core/small_letters.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace sunfleck {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCheckName = "check the name";

/// A path in quotes, on one line: control characters as the escapes that made them.
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

/// The entry of a folder that differs from `name` in case alone.
std::optional<fs::path> entry_of_other_case(const fs::path& folder, const std::string& name) {
    const std::string wanted = small_letters(name);
    std::error_code code;
    const fs::path shown = folder.empty() ? fs::path(".") : folder;
    for (fs::directory_iterator entry(shown, code), end; !code && entry != end;
         entry.increment(code))
        if (small_letters(entry->path().filename().string()) == wanted)
            return folder / entry->path().filename();
    return std::nullopt;
}

/// The file whose path differs in case alone, or nothing.
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
                              ", which is not there");
    if (const auto other = path_of_other_case(path))
        throw MissingFile(from, path,
                          "there is " + in_one_line(other->string()) + ": mind capital letters");
    throw MissingFile(from, path, std::string(kCheckName));
}

/// Refuses what is no regular file.
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
            throw Error(from, quoted + " is a device or a socket, no file", "name a file");
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

std::string read_input_file(const std::string& path, const SourceLocation& from) {
    check_kind(path, from);
    const std::string quoted = in_one_line(path);
    std::error_code code;
    const std::uintmax_t size = fs::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    if (code || !file)
        throw Error(from, quoted + " cannot be opened: " + std::strerror(errno),
                    "check that you may read it");
    constexpr std::uintmax_t kSmall = 1U << 24U;  // less is not worth the question
    if (size > kSmall && size > free_memory()) too_large(size, quoted, from);
    std::string bytes(size, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size)
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
        // The text grows by doubling: as much as there is must be free once more.
        if (filled > free_memory()) too_large(filled, "the text", {name});
    }
    if (std::ferror(stdin) != 0) throw Error({name}, "cannot be read to its end", "try again");
    return bytes;
}

}  // namespace sunfleck
