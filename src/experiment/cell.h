// A cell of an experiment: one render, named by what it is.
//
// Cells are run by `sunfleck render`, as its user would: each can be repeated by hand from the
// command that its statistics hold.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A way of rendering: its name in tables and folders, and the flags of `sunfleck render`.
struct Method {
    std::string name;
    std::vector<std::string> flags;
};

struct Cell {
    std::string scene;  // one of our own (procedural/scenes.h)
    Method method;
    std::uint64_t seed = 1;
    double budget = 1;  // of the unit of the run

    /// Its folder below that of all cells: cells of one name are one render.
    std::string key() const { return scene + "/" + method.name + "/seed-" + std::to_string(seed); }
};

/// A picture of another renderer, shown and measured beside ours.
struct OtherPicture {
    std::string scene;
    std::string label;
    std::string file;
};

/// What the user chose about a run of experiments.
struct RunSettings {
    std::string folder = "experiment";
    double cpu_seconds = 60;       // of a cell, all threads together; or
    std::uint32_t passes = 0;      // if not zero: passes of a cell instead
    double reference_budget = 10;  // of a reference, in cells
    std::uint64_t seeds = 5;
    double scale = 1;         // of the sides of all pictures, in (0,1]
    std::size_t threads = 0;  // all
    std::string program;      // this one
    std::vector<OtherPicture> others;
};

}  // namespace sunfleck::engine
