// Reads the statistics file that a render wrote (docs/reference/stats.md).
#pragma once

#include "core/file_content.h"
#include "core/input_file.h"

#include <string>

namespace sunfleck::engine {

/// Returns the text of the file, not parsed.
/// @throws Error  for a missing file, and for one whose first bytes show another type.
inline std::string read_statistics_file(const std::string& path) {
    std::string text = read_input_file(path, {path});
    if (!text.starts_with("{")) refuse_other_content(text, path, "the statistics of a render");
    return text;
}

}  // namespace sunfleck::engine
