// Tables for people and JSON for programs.
#pragma once

#include "evenness/measures.h"

#include <string>
#include <vector>

namespace sunfleck::engine::bench {

/// One scene: its classes, and the errors of each method in the order of the methods.
struct SceneResult {
    TestScene scene;
    Reference reference;
    std::vector<SceneErrors> methods;
};

struct Results {
    double cpu_seconds = 0;
    int resolution = 0;
    std::vector<Method> methods;
    std::vector<SceneResult> scenes;
};

/// Errors by class, spots and gains of each scene, then what the surround costs each view.
std::string results_text(const Results& results);

/// The same as JSON, without paths.
std::string evenness_json(const Results& results);

}  // namespace sunfleck::engine::bench
