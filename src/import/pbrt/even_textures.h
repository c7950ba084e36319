// Values that hold for a whole surface, where the scene gives a texture: its mean.
#pragma once

#include "import/pbrt/assets.h"
#include "import/pbrt/parameters.h"
#include "math/spectrum.h"

#include <functional>
#include <optional>

namespace sunfleck::engine {

/// A number, or the mean of a float texture over the unit square of (u, v), with a warning.
/// @return nothing when not given.
std::optional<float> even_number(const Statement& statement, const std::string& name,
                                 Assets& assets);

/// The same of a spectrum, at 5 nm.
std::optional<Spectrum> even_curve(const Statement& statement, const std::string& name,
                                   SpectrumUse use, Assets& assets);

/// A function of the wavelength as a curve, at 5 nm from 360 to 830.
Spectrum tabulated(const std::function<float(float)>& value);

}  // namespace sunfleck::engine
