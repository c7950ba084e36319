// Parameters that are spectra: rgb, blackbody, sampled, named, or in a file.
#pragma once

#include "import/pbrt/import_log.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/scene_files.h"
#include "math/spectrum.h"

namespace sunfleck::engine {

/// What the spectrum is for: it says what an rgb stands for (pbrt-v4).
enum class SpectrumUse {
    reflectance,  // rgb in [0,1]
    unbounded,    // absorption, scattering
    index,        // eta, k: unbounded; a table's end values go on beyond it
    emission      // rgb under D65; all other spectra are divided by their luminance
};

/// Reads spectra out of parameters, and out of the files that these name.
class SpectrumReader {
public:
    /// Both must outlive this.
    SpectrumReader(SceneFiles& files, ImportLog& log) : files_(files), log_(log) {}

    /// @throws Error for numbers that no such spectrum can have, unknown names, missing files.
    Spectrum curve(const Parameter& parameter, SpectrumUse use);

    /// The spectrum of that name, or nothing. A "texture" is an Error here.
    std::optional<Spectrum> find(const Statement& statement, std::string_view name,
                                 SpectrumUse use);

    /// Emission by a parameter; where there is none, the white of the present colour space, of
    /// luminance one. @param present  that space.
    Spectrum emission(const Statement& statement, std::string_view name, ColourSpace present);

private:
    Spectrum raw_curve(const Parameter& parameter, SpectrumUse use);
    Spectrum by_name(const Parameter& parameter, SpectrumUse use);
    Spectrum from_file(const std::string& name, const Parameter& parameter, SpectrumUse use);

    SceneFiles& files_;
    ImportLog& log_;
};

}  // namespace sunfleck::engine
