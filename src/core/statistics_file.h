// The file of statistics that a render writes (docs/reference/stats.md), for what reads it again.
#pragma once

#include "core/file_content.h"
#include "core/input_file.h"

#include <string>

namespace sunfleck::engine {

/// The text of the file, not parsed.
/// @throws Error  for a file that is not there, or that is something else by its first bytes.
inline std::string read_statistics_file(const std::string& path) {
    std::string text = read_input_file(path, {path});
    if (!text.starts_with("{")) refuse_other_content(text, path, "the statistics of a render");
    return text;
}

}  // namespace sunfleck::engine
