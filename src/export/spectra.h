// Spectra as parameters of pbrt-v4 statements.
//
// Greys and the smooth spectra of colours are written as rgb where that reads back to the same
// curve within kCurveError of its greatest value, all others as tables with that error at most
// between their points (whole nanometres from 360 to 830). Tables are written point by point.
#pragma once

#include "export/statement_text.h"
#include "math/spectrum.h"
#include "texture/image_kind.h"

#include <functional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

inline constexpr float kCurveError = 1e-5F;

/// Returns a table that is linear between as few whole nanometres as keep to kCurveError.
Spectrum sparse_table(const std::function<float(float nm)>& curve);

/// Adds a reflectance or an unbounded quantity.
/// @param use  albedo or unbounded: how a colour is read there.
void add_spectrum(StatementText& statement, std::string_view name, const Spectrum& curve,
                  ColourUse use);

/// Adds an index of refraction: a float where it is the same for all wavelengths.
void add_index(StatementText& statement, std::string_view name, const Spectrum& eta);

/// Adds an emission, with a scale where it needs one: pbrt-v4 divides by the luminance of what is
/// no rgb.
void add_emission(StatementText& statement, std::string_view name, const Spectrum& curve,
                  std::string_view scale = "scale");

/// Returns whether a curve is D65, times any number.
bool is_d65(const Spectrum& curve);

}  // namespace sunfleck::engine
