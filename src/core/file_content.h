// Detection of a file's type by its first bytes, for users who named one type in place of another.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// A type of content that is recognised by its bytes.
struct FileContent {
    std::string_view what;  // completes the sentence "FILE is ...": "a PNG picture"
    std::string_view
        mend;  // how to get the intended file; empty if the user must name another file
};

/// Returns the type of the bytes, or nothing for unknown content, such as plain text.
std::optional<FileContent> content_of(std::string_view bytes);

/// Throws if content_of() recognises the bytes.
/// @param name  file name for the message.
/// @param wanted  completes "where ... is read": "a PLY mesh".
/// @throws Error  that names the type found.
void refuse_other_content(std::string_view bytes, const std::string& name,
                          const std::string& wanted);

/// The byte order mark of UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Returns the text without its UTF-8 byte order mark, if it has one.
inline std::string_view without_mark(std::string_view text) {
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

}  // namespace sunfleck::engine
