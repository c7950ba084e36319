// URIs of glTF: data in the text itself (base64), and names of files with %-escapes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Returns the bytes of base64, or nothing for text that is none. Padding may be missing.
std::optional<std::string> from_base64(std::string_view text);

/// A "data:" URI: media type ("image/png"), and bytes.
struct DataUri {
    std::string type;
    std::string bytes;
};

inline bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:");
}

/// Returns nothing for a data URI that is not base64, or damaged.
std::optional<DataUri> data_of(std::string_view uri);

/// Replaces %XX by its byte; other text, a stray % among it, stays.
std::string without_escapes(std::string_view uri);

/// Returns the names under which the file of a URI may be found, the right one first: without
/// escapes, as it stands, and with the slashes of Windows turned.
std::vector<std::string> names_of_file(std::string_view uri);

}  // namespace sunfleck::engine
