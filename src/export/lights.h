// Lights as pbrt-v4 statements.
#pragma once

#include "export/picture_files.h"
#include "export/statement_text.h"
#include "light/light.h"
#include "scene/description.h"

#include <map>
#include <memory>
#include <string>

namespace sunfleck::engine {

class LightStatements {
public:
    /// All must outlive this.
    LightStatements(PictureFiles& pictures, Warnings& warnings)
        : pictures_(pictures), warnings_(warnings) {}

    /// Returns the statement of a light, with its frame. @param where  for warnings.
    std::string of(const Light& light, const SourceLocation& where);

    /// Returns the statement that makes shapes to come emit.
    std::string area(const AreaEmission& emission);

private:
    PictureFiles& pictures_;
    Warnings& warnings_;
    std::map<std::shared_ptr<const SurfaceImage>, std::string> surface_images_;
};

}  // namespace sunfleck::engine
