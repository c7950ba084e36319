// What a file is by its first bytes, for users who named one kind of file in place of another.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// A kind of content that can be told by its bytes.
struct FileContent {
    std::string_view what;  // follows "is": "a PNG picture"
    std::string_view mend;  // how to get at the file that was meant; empty: give another file
};

/// The kind of the bytes, or nothing for other content, such as plain text.
std::optional<FileContent> content_of(std::string_view bytes);

/// Refuses bytes that content_of() knows.
/// @param name  of the file. @param wanted  follows "where": "a PLY mesh".
/// @throws Error, which says what the file is.
void refuse_other_content(std::string_view bytes, const std::string& name,
                          const std::string& wanted);

/// The byte order mark of UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The text behind a byte order mark of UTF-8, if there is one.
inline std::string_view without_mark(std::string_view text) {
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

}  // namespace sunfleck::engine
