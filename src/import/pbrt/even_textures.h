// Constant values for parameters that cannot vary over a surface: the mean of a texture.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "math/spectrum.h"

#include <functional>
#include <optional>

namespace sunfleck::engine {

/// Returns a number, or the mean of a float texture over the unit square of (u, v), with a warning.
/// @return nothing if the parameter is not given.
std::optional<float> even_number(const Statement& statement, const std::string& name,
                                 Assets& assets);

/// Returns a spectrum, or the mean of a spectrum texture in steps of 5 nm.
std::optional<Spectrum> even_curve(const Statement& statement, const std::string& name,
                                   SpectrumUse use, Assets& assets);

/// Tabulates a function of the wavelength in steps of 5 nm from 360 to 830.
Spectrum tabulated(const std::function<float(float)>& value);

}  // namespace sunfleck::engine
