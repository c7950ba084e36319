// Media of a scene file: numbers that shapes, lights and the camera refer to, filled in when all
// files have ended.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/spectra.h"
#include "scene/media.h"

#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

class MediumTable {
public:
    /// MakeNamedMedium. @throws Error for a name made before, or an unknown type.
    void make(Statement statement);
    /// The number of a medium, which may be made later; empty space for an empty name.
    /// @param from  the statement that uses it.
    MediumNumber number_of(const std::string& name, const SourceLocation& from);
    /// Adds all that are used to the scene's media. The log is told what is not simulated of them.
    /// @throws Error for names that were never made, and for parameters that cannot be used.
    void finish(SpectrumReader& spectra, ImportLog& log, Media& media) const;

private:
    struct Use {
        std::string name;
        SourceLocation from;
    };

    std::map<std::string, Statement> made_;
    std::map<std::string, MediumNumber> numbers_;
    std::vector<Use> uses_;  // by number, from 1
};

}  // namespace sunfleck::engine
