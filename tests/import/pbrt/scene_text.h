// Scenes of a few lines for tests, with other files held in memory.
#pragma once

#include "import/pbrt/reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

namespace sunfleck::engine {

using MemoryFiles = std::map<std::string, std::string>;

inline FileAccess memory_access(const MemoryFiles& files) {
    return [files](const std::string& path, const SourceLocation& from) {
        const auto found = files.find(path);
        if (found == files.end()) throw MissingFile(from, path, "make it");
        return found->second;
    };
}

inline SceneDescription read_text(const std::string& text, const MemoryFiles& files = {}) {
    return read_pbrt_text(text, "main.pbrt", memory_access(files));
}

/// Reads what stands after WorldBegin.
inline SceneDescription read_world(const std::string& text, const MemoryFiles& files = {}) {
    return read_text("WorldBegin\n" + text, files);
}

/// The one-line message of the Error that reading the text throws; empty if it throws none.
inline std::string error_of(const std::string& text, const MemoryFiles& files = {}) {
    try {
        read_text(text, files);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

inline std::string world_error(const std::string& text, const MemoryFiles& files = {}) {
    return error_of("WorldBegin\n" + text, files);
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// How often a warning that contains `part` was given.
inline int warnings_with(const SceneDescription& scene, const std::string& part) {
    int count = 0;
    for (const auto& entry : scene.warnings.entries())
        if (contains(entry.text, part)) count += entry.count;
    return count;
}

inline bool near(double a, double b, double tolerance = 1e-6) {
    return std::abs(a - b) <= tolerance;
}

}  // namespace sunfleck::engine
