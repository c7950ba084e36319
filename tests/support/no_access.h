// A file access that refuses every file, for tests that read text alone.
#pragma once

#include "import/pbrt/file_access.h"
#include "import/pbrt/words.h"
#include "sunfleck/error.h"

namespace sunfleck::engine::testing_support {

/// Refuses every file.
inline FileAccess no_access() {
    return [](const std::string& path, const SourceLocation& from) -> std::string {
        throw Error(from, "other files are not read here: " + in_quotes(path), "leave them out");
    };
}

}  // namespace sunfleck::engine::testing_support
