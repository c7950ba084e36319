// Reading: the state of an import, with the scene so far and what later statements need.
//
// In:  statements in order (directives.h). Out: finish() completes what had to wait for the end.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/graphics_state.h"
#include "import/pbrt/import_log.h"
#include "import/pbrt/inclusions.h"
#include "import/pbrt/material_table.h"
#include "import/pbrt/medium_table.h"

#include <map>

namespace sunfleck::engine {

/// Statements of which the last one counts, converted at the end of all files.
struct Options {
    std::optional<Statement> camera;
    std::optional<Statement> film;
    std::optional<Statement> filter;
    std::optional<Statement> sampler;
    std::optional<Statement> integrator;
    Motion camera_from_world;   // matrix at the Camera statement
    std::string camera_medium;  // outside medium there; empty for none
};

/// An ObjectInstance; its object may come later in the file.
struct InstanceUse {
    std::string name;
    Matrix to_world;
    SourceLocation where;
};

/// A log, and the assets that write to it; a copy writes to a log of its own.
struct LoggedAssets {
    LoggedAssets(const std::string& main_file, FileAccess access)
        : assets(main_file, std::move(access), log) {}
    LoggedAssets(const LoggedAssets& other) : log(other.log), assets(other.assets, log) {}
    LoggedAssets& operator=(const LoggedAssets&) = delete;
    LoggedAssets(LoggedAssets&&) = delete;
    LoggedAssets& operator=(LoggedAssets&&) = delete;
    ~LoggedAssets() = default;

    ImportLog log;
    Assets assets;
};

struct Reading : LoggedAssets {
    /// @param path  of the main file.
    Reading(const std::string& path, FileAccess access) : LoggedAssets(path, std::move(access)) {
        scene.path = path;
    }

    SceneDescription scene;

    GraphicsState state;
    std::vector<Block> blocks;
    std::size_t block_base = 0;  // open blocks at the start of the current Import
    bool in_world = false;
    Options options;
    std::map<std::string, Motion> coordinate_systems;
    std::array<double, 2> transform_times{0, 1};
    Vec3d curve_origin{0};  // origin of the last curve's control points

    MaterialTable materials;
    MediumTable media;
    Parameters defaults;  // from Attribute, by category
    std::map<std::string, std::uint32_t> objects;
    std::optional<std::uint32_t> open_object;
    std::vector<InstanceUse> instances;
    Inclusions inclusions;

    /// Warns of Attribute parameters that no statement used; called at the end.
    void warn_unused_defaults();
    /// @throws Error  if more than the outer `base` blocks are open.
    void check_blocks_closed(std::size_t base) const;
    /// Returns the current matrix in the middle of the exposure; warns if it moves.
    Matrix still_matrix(const SourceLocation& where);
    /// Returns a matrix in the middle of the exposure; warns if it moves.
    Matrix still(const Motion& motion, const SourceLocation& where);
};

}  // namespace sunfleck::engine
