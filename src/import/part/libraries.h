// PartLibraries: the libraries of materials that an OBJ file names.
#pragma once

#include "import/obj/mesh.h"
#include "import/part/files.h"
#include "import/part/mtl_looks.h"
#include "scene/import_settings.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

class PartLibraries {
public:
    /// Reads the libraries. A statement names one whose name may have blanks, or several.
    PartLibraries(PartFiles& files, const std::vector<ObjName>& statements, Warnings& warnings);

    struct Match {
        const MtlMaterial* material = nullptr;
        const PartLibrary* library = nullptr;
    };
    /// Returns the first material of a name.
    std::optional<Match> find(const std::string& name) const;

    /// Returns whether a library could not be found.
    bool are_missing() const { return are_missing_; }

    /// Tells of files that are missing. Libraries alone are a warning where --material names what
    /// is used in place of their materials.
    /// @throws Error  that names them all.
    void check_missing(const PartFiles& files, const ImportSettings& settings,
                       Warnings& warnings) const;

private:
    std::vector<PartLibrary> libraries_;
    bool are_missing_ = false;
};

}  // namespace sunfleck::engine
