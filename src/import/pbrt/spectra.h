// Parameters that are spectra: rgb, blackbody, sampled, named, or in a file.
#pragma once

#include "import/pbrt/parameters.h"
#include "math/spectral_curve.h"

namespace sunfleck {

struct Reading;

/// What the spectrum is for: it says what an rgb stands for (pbrt-v4).
enum class SpectrumUse {
    reflectance,  // rgb in [0,1]
    unbounded,    // absorption, scattering
    index,        // eta, k: unbounded; a table's end values go on beyond it
    emission      // rgb under D65; all other spectra are divided by their luminance
};

/// @throws Error for numbers that no such spectrum can have, unknown names, missing files.
SpectralCurve curve_of(const Parameter& parameter, SpectrumUse use, Reading& reading);

/// The spectrum of that name, or nothing. A "texture" is an Error here.
std::optional<SpectralCurve> find_curve(const Statement& statement, std::string_view name,
                                        SpectrumUse use, Reading& reading);

/// Emission by a parameter; where there is none, the white of the present colour space, of
/// luminance one.
SpectralCurve emission_of(const Statement& statement, std::string_view name, Reading& reading);

}  // namespace sunfleck
