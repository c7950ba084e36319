// The folder of a run of experiments: scenes, finished cells, what they were made with.
//
//     run.json                          what the run was asked for
//     scenes/NAME/NAME.pbrt             our own scenes
//     cells/SCENE/METHOD/seed-N/        passes-*.exr and .json (sunfleck render --snapshots),
//     log.txt
//
// A cell's folder gets its name when the cell is finished: what has its name is never rendered
// again. Before it is called seed-N.part; a long cell has a checkpoint there, and goes on from it.
#pragma once

#include "experiment/cell.h"

#include <atomic>
#include <string>

namespace sunfleck::engine {

/// Thrown when the user has asked to stop; finished cells stay.
struct Interrupted {};

class CellStore {
public:
    /// Makes the folder, or goes on with one.
    /// @throws Error if the folder holds a run of other settings, naming the first that differs.
    explicit CellStore(RunSettings settings);

    const RunSettings& settings() const { return settings_; }
    bool has(const Cell& cell) const;
    /// Processor seconds that a cell takes, about; zero when the budget is in passes.
    double expected_seconds(const Cell& cell) const;
    /// Renders the cell.
    /// @throws Error with the renderer's own last words if that fails; Interrupted.
    void run(const Cell& cell, const std::atomic<bool>* interrupted) const;

    /// Of a finished cell.
    std::string folder(const Cell& cell) const;
    /// The scene's file, written at the first call.
    std::string scene_file(const std::string& scene) const;

private:
    std::vector<std::string> command(const Cell& cell, const std::string& target) const;

    RunSettings settings_;
};

}  // namespace sunfleck::engine
