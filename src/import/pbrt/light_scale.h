// The emission of a light statement, and the numbers that scale it.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/reading.h"
#include "math/spectrum.h"

namespace sunfleck::engine {

/// Returns the spectrum of that name, or the white of the current colour space.
inline Spectrum emission_of(const Statement& statement, std::string_view name, Reading& reading) {
    return reading.assets.spectra.emission(statement, name, reading.state.colour_space);
}

/// A parameter that gives a light's total: a positive "power" or "illuminance" replaces the total
/// that the light has at scale one. Without a name there is no such parameter.
struct LightTotal {
    std::string_view name;
    double at_one = 0;
};

/// Returns the curve times "scale", and times the total over that at scale one if a total is given.
/// @param peak  the brightest texel of the light's image, which multiplies the curve.
/// @throws Error  for a negative "scale", and for a product that is no finite float.
Spectrum scaled_emission(const Statement& statement, const Spectrum& curve, const LightTotal& total,
                         double peak = 1);

}  // namespace sunfleck::engine
