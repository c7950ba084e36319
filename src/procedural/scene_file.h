// ProceduralScene and SceneFile: the name of a scene, and the files that it consists of.
#pragma once

#include <string>

namespace sunfleck::engine {

struct ProceduralScene {
    std::string name;
    std::string what;  // description of one line
};

struct SceneFile {
    std::string name;  // relative to the scene's folder, with '/'
    std::string bytes;
};

}  // namespace sunfleck::engine
