// ExportedScene: a scene as files of another format, and what that format cannot say.
#pragma once

#include "core/warnings.h"

#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A file to be written. Its bytes are made when they are asked for, so that large scenes need not
/// be in memory twice; what they are made of lives as long as the scene's description.
struct ExportedFile {
    std::string name;  // relative to the folder of the scene, with '/'
    std::function<std::string()> bytes;
};

struct ExportedScene {
    std::vector<ExportedFile> files;  // the main file is the last
    Warnings warnings;                // what was written in place of what cannot be said
};

}  // namespace sunfleck::engine
