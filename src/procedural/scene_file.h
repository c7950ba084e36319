// A procedural scene's name, and the files that it is written to.
#pragma once

#include <string>

namespace sunfleck::engine {

struct ProceduralScene {
    std::string name;
    std::string what;  // one line
};

struct SceneFile {
    std::string name;  // relative to the folder of the scene, with '/'
    std::string bytes;
};

}  // namespace sunfleck::engine
