// Checks of single statements whose conversion waits for the end of the scene: their types and
// values, as far as they can be judged without what other statements make.
//
// Textures that a statement names, and files that are missing, are left to the end.
#pragma once

#include "import/pbrt/parameters.h"

#include <string>
#include <utility>

namespace sunfleck::engine {

/// @throws Error  as camera_of() does, and for an exposure of no time.
void check_camera(const Statement& camera, const Matrix& to_world);
/// @throws Error  as film_of() does.
void check_film(const Statement& film);
/// @throws Error  as filter_of() does.
void check_filter(const Statement& filter);

/// Checks statements that may read files.
class StatementChecks {
public:
    /// @param path  stands for the path of the scene: relative names start at its folder.
    explicit StatementChecks(std::string path) : path_(std::move(path)) {}

    /// Each throws Error for an unknown type, and for values out of range.
    void material(const std::string& name, const Statement& material) const;
    void medium(const Statement& medium) const;
    /// @param kind  "float" or "spectrum".
    void texture(const std::string& kind, const std::string& name, const Statement& texture,
                 const Matrix& to_world) const;

private:
    std::string path_;
};

}  // namespace sunfleck::engine
