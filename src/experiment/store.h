// CellStore: the folder of an experiment, with scenes, finished cells, and the settings.
//
// run.json                          the settings
// scenes/NAME/NAME.pbrt             procedural scenes
// cells/SCENE/METHOD/seed-N/        passes-*.exr and .json (sunfleck render --snapshots),
// log.txt
//
// The folder of a cell gets its name when the cell is finished, and is never rendered again. Before
// that it is called seed-N.part; a long cell has a checkpoint there, and continues from it.
#pragma once

#include "experiment/cell.h"
#include "procedural/scene_file.h"

#include <atomic>
#include <string>

namespace sunfleck::engine {

/// Writes the files of a procedural scene, the main one last, so that where it stands all stand.
/// @return its path.
std::string write_scene(const std::string& folder, const std::vector<SceneFile>& files);

/// Thrown if the user asks to stop; finished cells are kept.
struct Interrupted {};

class CellStore {
public:
    /// Creates the folder, or continues with an existing one.
    /// @throws Error  if the folder holds an experiment with other settings; it names the first
    /// difference.
    explicit CellStore(RunSettings settings);

    const RunSettings& settings() const { return settings_; }
    bool has(const Cell& cell) const;
    /// Returns the expected processor time of a cell in seconds; zero if the budget is in passes.
    double expected_seconds(const Cell& cell) const;
    /// Renders the cell.
    /// @throws Error  with the renderer's last message if that fails; Interrupted.
    void run(const Cell& cell, const std::atomic<bool>* interrupted) const;

    /// Returns the folder of a finished cell.
    std::string folder(const Cell& cell) const;
    /// Returns the scene file, which the first call writes.
    std::string scene_file(const std::string& scene) const;

private:
    std::vector<std::string> command(const Cell& cell, const std::string& target) const;

    RunSettings settings_;
};

}  // namespace sunfleck::engine
