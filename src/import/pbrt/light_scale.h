// The emission of a light statement, and the numbers that scale it.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/reading.h"
#include "math/spectrum.h"

#include <algorithm>

namespace sunfleck::engine {

/// The spectrum of that name, or the white of the present colour space.
inline Spectrum emission_of(const Statement& statement, std::string_view name, Reading& reading) {
    return reading.assets.spectra.emission(statement, name, reading.state.colour_space);
}

/// "scale". @throws Error for a negative one.
inline double scale_of(const Statement& statement) {
    const double scale = statement.real("scale", 1);
    if (scale >= 0) return scale;
    throw Error(statement.find("scale")->where, "a light of negative \"scale\"", "use 0 or more");
}

/// A positive "power" or "illuminance" over what the light has at scale one; else one.
inline double factor_by(const Statement& statement, std::string_view name, double at_one) {
    const double wanted = statement.real(name, 0);
    return wanted > 0 ? wanted / at_one : 1;
}

inline Spectrum scaled(const Spectrum& curve, double factor) {
    return curve.scaled(static_cast<float>(std::min(factor, 1e30)));
}

}  // namespace sunfleck::engine
