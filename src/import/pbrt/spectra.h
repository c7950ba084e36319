// Conversion of spectrum parameters: rgb, blackbody, sampled, named, or from a file.
#pragma once

#include "import/pbrt/import_log.h"
#include "import/pbrt/parameters.h"
#include "import/pbrt/scene_files.h"
#include "math/spectrum.h"

namespace sunfleck::engine {

/// Use of a spectrum, which decides what an rgb means (pbrt-v4).
enum class SpectrumUse {
    reflectance,  // rgb in [0,1]
    unbounded,    // absorption, scattering
    index,        // eta, k: unbounded; end values of a table extend beyond it
    emission      // rgb under D65; other spectra are divided by their luminance
};

/// Reads spectra from parameters, and from the files that they name.
class SpectrumReader {
public:
    /// Both must outlive this.
    SpectrumReader(SceneFiles& files, ImportLog& log) : files_(files), log_(log) {}

    /// @throws Error  for invalid numbers, unknown names, missing files.
    Spectrum curve(const Parameter& parameter, SpectrumUse use);

    /// Returns the spectrum of that name, or nothing. @throws Error  for a "texture".
    std::optional<Spectrum> find(const Statement& statement, std::string_view name,
                                 SpectrumUse use);

    /// Returns the emission of a parameter; without it, the white of a colour space with luminance
    /// one.
    /// @param present  current colour space.
    Spectrum emission(const Statement& statement, std::string_view name, ColourSpace present);

private:
    Spectrum raw_curve(const Parameter& parameter, SpectrumUse use);
    Spectrum by_name(const Parameter& parameter, SpectrumUse use);
    Spectrum from_file(const std::string& name, const Parameter& parameter, SpectrumUse use);

    SceneFiles& files_;
    ImportLog& log_;
};

}  // namespace sunfleck::engine
