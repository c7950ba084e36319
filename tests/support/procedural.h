// Our own scenes, read from memory, at any size.
#pragma once

#include "import/pbrt/reader.h"
#include "procedural/scenes.h"
#include "scene/adjust.h"
#include "scene/scene.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

/// A scene of `sunfleck scene`, at n x n pixels.
inline Scene procedural(const std::string& name, int n) {
    const std::vector<SceneFile> files = make_scene(name);
    const FileAccess access = [&](const std::string& path, const SourceLocation&) {
        for (const SceneFile& file : files)
            if (path.ends_with(file.name)) return file.bytes;
        throw std::runtime_error("no file " + path);
    };
    SceneDescription description = read_pbrt_text(files.at(0).bytes, files.at(0).name, access);
    set_resolution(description, {n, n});
    return Scene(std::move(description));
}

}  // namespace sunfleck::engine::testing_support
