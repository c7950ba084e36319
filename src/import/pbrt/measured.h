// Measured materials: the data of their files that an approximation needs.
#pragma once

#include "math/spectrum.h"
#include "sunfleck/error.h"

#include <string>

namespace sunfleck::engine {

struct MeasuredSummary {
    Spectrum albedo;  // under diffuse illumination, in [0,1]
    float alpha = 1;  // of GGX facets with the same median slope
};

/// @param bytes  of a .bsdf file with spectra. @throws Error  (at `from`) for a damaged one.
///
/// A material is f = spectra(u) D(h) / (4 sigma(w) cos), where u in (0,1)^2 samples the visible
/// normal h. So the mean of `spectra` over u is the albedo for direction w. Source: Dupuy and Jakob
/// 2018, equations 8 and 9.
MeasuredSummary summary_of_measured(const std::string& bytes, const SourceLocation& from);

}  // namespace sunfleck::engine
