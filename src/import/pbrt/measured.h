// Measured materials: what of their files a simple stand-in needs.
#pragma once

#include "math/spectrum.h"
#include "sunfleck/error.h"

#include <string>

namespace sunfleck::engine {

struct MeasuredSummary {
    Spectrum albedo;  // of evenly spread light, in [0,1]
    float alpha = 1;  // of GGX facets of which half are tilted as little as half of these are
};

/// @param bytes  of a .bsdf file with spectra. @throws Error  (place `from`) for a broken one.
///
/// A material is f = spectra(u) D(h) / (4 sigma(w) cos), where u are the numbers of (0,1)^2 that
/// choose the facet h among those that w sees: so the mean of `spectra` over u is the share of the
/// light of w that is scattered. Source: Dupuy and Jakob 2018, equations 8 and 9.
MeasuredSummary summary_of_measured(const std::string& bytes, const SourceLocation& from);

}  // namespace sunfleck::engine
