// Cell: one render of an experiment, identified by scene, method and seed.
//
// Cells run as `sunfleck render`, so that each can be repeated by hand with the command that its
// statistics contain.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A rendering method: its name in tables and folders, and its flags for `sunfleck render`.
struct Method {
    std::string name;
    std::vector<std::string> flags;
};

struct Cell {
    std::string scene;  // a procedural scene (procedural/scenes.h)
    Method method;
    std::uint64_t seed = 1;
    double budget = 1;  // in units of the run's budget

    /// Returns the folder relative to that of all cells: cells with one key are one render.
    std::string key() const { return scene + "/" + method.name + "/seed-" + std::to_string(seed); }
};

/// A picture of another renderer, shown and measured beside ours.
struct OtherPicture {
    std::string scene;
    std::string label;
    std::string file;
};

/// The user's settings of an experiment.
struct RunSettings {
    std::string folder = "experiment";
    double cpu_seconds = 60;       // per cell, all threads together; or
    std::uint32_t passes = 0;      // if not zero: passes per cell instead
    double reference_budget = 10;  // of a reference, in cells
    std::uint64_t seeds = 5;
    double scale = 1;         // factor of the sides of all pictures, in (0,1]
    std::size_t threads = 0;  // zero for all
    std::string program;      // path of this program
    std::vector<OtherPicture> others;
};

}  // namespace sunfleck::engine
