// MediumTable: the media of a scene, by the numbers that shapes, lights and the camera use; filled
// in at the end.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "scene/media.h"

#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

class MediumTable {
public:
    /// Adds a MakeNamedMedium. @param to_world  places what varies in space.
    /// @throws Error  for a repeated name, or an unknown type.
    void make(Statement statement, const Matrix& to_world = Matrix());
    /// Returns the number of a medium, which may be made later; empty space for an empty name.
    /// @param from  statement that uses it.
    MediumNumber number_of(const std::string& name, const SourceLocation& from);
    /// Adds all used media to the scene's, and warns of what is not simulated.
    /// @throws Error  for names that were never made, and for invalid parameters.
    void finish(Assets& assets, Media& media) const;

private:
    struct Made {
        Statement statement;
        Matrix to_world;
    };
    static Medium medium_of(const std::string& name, const Made& made, Assets& assets);

    struct Use {
        std::string name;
        SourceLocation from;
    };

    std::map<std::string, Made> made_;
    std::map<std::string, MediumNumber> numbers_;
    std::vector<Use> uses_;  // by number, from 1
};

}  // namespace sunfleck::engine
