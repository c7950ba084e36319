// A reading in progress: the scene so far, and what later statements need to know.
//
// In:  statements, one after the other (directives.h). Out: finish() fills in what had to wait.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/graphics_state.h"
#include "import/pbrt/import_log.h"
#include "import/pbrt/inclusions.h"
#include "import/pbrt/material_table.h"
#include "import/pbrt/medium_table.h"

#include <map>

namespace sunfleck::engine {

/// Statements of which the last one counts, read when all files have ended.
struct Options {
    std::optional<Statement> camera;
    std::optional<Statement> film;
    std::optional<Statement> filter;
    std::optional<Statement> sampler;
    std::optional<Statement> integrator;
    Motion camera_from_world;  // the matrix at the Camera statement
};

/// An ObjectInstance, whose object may come later in the file.
struct InstanceUse {
    std::string name;
    Matrix to_world;
    SourceLocation where;
};

struct Reading {
    /// @param path  of the main file.
    Reading(const std::string& path, FileAccess access) : assets(path, std::move(access), log) {
        scene.path = path;
    }

    SceneDescription scene;
    ImportLog log;
    Assets assets;

    GraphicsState state;
    std::vector<Block> blocks;
    std::size_t block_base = 0;  // blocks that the present Import found open
    bool in_world = false;
    Options options;
    std::map<std::string, Motion> coordinate_systems;
    std::array<double, 2> transform_times{0, 1};
    Vec3d curve_origin{0};  // that the control points of the last curve are relative to

    MaterialTable materials;
    MediumTable media;
    Parameters defaults;  // given by Attribute, for whoever asks
    std::map<std::string, std::uint32_t> objects;
    std::optional<std::uint32_t> open_object;
    std::vector<InstanceUse> instances;
    Inclusions inclusions;

    /// Warns of parameters given by Attribute that no statement asked for: at the end.
    void warn_unused_defaults();
    /// @throws Error if more than the outer `base` blocks are open.
    void check_blocks_closed(std::size_t base) const;
    /// The matrix of the graphics state in the middle of the exposure; warns where it moves.
    Matrix still_matrix(const SourceLocation& where);
    /// Any motion in the middle of the exposure; warns if there is one.
    Matrix still(const Motion& motion, const SourceLocation& where);
};

}  // namespace sunfleck::engine
