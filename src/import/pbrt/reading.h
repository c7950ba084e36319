// A reading in progress: the scene so far, and what later statements need to know.
//
// In:  statements, one after the other (directives.h). Out: finish() fills in what had to wait.
#pragma once

#include "import/pbrt/file_access.h"
#include "import/pbrt/graphics_state.h"
#include "import/pbrt/images.h"
#include "import/pbrt/inclusions.h"
#include "import/pbrt/material_table.h"
#include "import/pbrt/medium_table.h"
#include "import/pbrt/textures.h"

#include <map>
#include <set>

namespace sunfleck {

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
    SceneDescription scene;
    FileAccess files;
    std::string folder;  // of the main file

    GraphicsState state;
    std::vector<Block> blocks;
    std::size_t block_base = 0;  // blocks that the present Import found open
    bool in_world = false;
    Options options;
    std::map<std::string, Motion> coordinate_systems;
    std::array<double, 2> transform_times{0, 1};
    Vec3d curve_origin{0};  // that the control points of the last curve are relative to

    MaterialTable materials;
    TextureTable textures;
    ImageTable images;
    MediumTable media;
    std::set<const Statement*> sound_mixes;  // named ones that are known to end
    Parameters defaults;                     // given by Attribute, for whoever asks
    std::map<std::string, std::uint32_t> objects;
    std::map<std::pair<std::string, std::string>, std::size_t> words;  // count by directive, word
    std::optional<std::uint32_t> open_object;
    std::vector<InstanceUse> instances;
    std::set<std::string> files_read;
    Inclusions inclusions;
    std::vector<MissingFile> missing;  // each path once

    /// Counts a word that the scene uses: of the directive `Shape`, `sphere`.
    void count_word(std::string_view directive, std::string_view word);
    /// Adds a warning; after some hundred different ones only that there are more.
    void warn(const SourceLocation& where, const std::string& text);
    /// Warns of parameters that nobody asked for.
    void warn_unused(const Statement& statement);
    /// The same, of those given by Attribute: at the end.
    void warn_unused_defaults();
    /// A file named in the scene, which is entered in the list of files. @throws as find_file().
    NamedFile read_file(const std::string& name, const SourceLocation& from);
    /// What a reader makes of a data file. @param reader  takes a NamedFile; its faults are told
    /// with the statement that asked for the file.
    template <class Reader>
    auto read_data(const std::string& name, const SourceLocation& from, const Reader& reader) {
        try {
            return reader(read_file(name, from));
        } catch (const Error& fault) {
            if (fault.where().file == from.file) throw;
            throw fault.asked_for_at(from);
        }
    }
    /// Enters a file in the list, and warns if it was found by slashes for its backslashes.
    void note_file(const NamedFile& file, const SourceLocation& from);
    /// Notes a missing file, so that all of them are told at once.
    void note_missing(const MissingFile& missing);
    /// @throws Error  that lists the missing files, if there are any.
    void check_missing() const;
    /// @throws Error if more than the outer `base` blocks are open.
    void check_blocks_closed(std::size_t base) const;
    /// The matrix of the graphics state in the middle of the exposure; warns where it moves.
    Matrix still_matrix(const SourceLocation& where);
    /// Any motion in the middle of the exposure; warns if there is one.
    Matrix still(const Motion& motion, const SourceLocation& where);
};

}  // namespace sunfleck
