// Assets: the files, spectra, images and textures that parameters refer to. Functions that make a
// material of a statement need these and the log, but no other state of the import.
#pragma once

#include "import/pbrt/images.h"
#include "import/pbrt/import_log.h"
#include "import/pbrt/scene_files.h"
#include "import/pbrt/spectra.h"
#include "import/pbrt/textures.h"
#include "scene/import_settings.h"

#include <string>
#include <utility>

namespace sunfleck::engine {

struct Assets {
    /// @param log  must outlive this.
    Assets(const std::string& main_file, FileAccess access, ImportLog& its_log)
        : log(its_log), files(main_file, std::move(access), log) {}
    /// Makes a copy that writes to another log.
    Assets(const Assets& other, ImportLog& its_log)
        : subsurface(other.subsurface),
          log(its_log),
          files(other.files, log),
          images(other.images, files, log),
          textures(other.textures, spectra, images, log) {}
    ~Assets() = default;
    Assets(const Assets&) = delete;  // its members refer to each other
    Assets& operator=(const Assets&) = delete;
    Assets(Assets&&) = delete;
    Assets& operator=(Assets&&) = delete;

    SubsurfaceRule subsurface = SubsurfaceRule::approximated;
    ImportLog& log;
    SceneFiles files;
    SpectrumReader spectra{files, log};
    ImageTable images{files, log};
    TextureTable textures{spectra, images, log};
};

}  // namespace sunfleck::engine
