// Spectral upsampling: fits a smooth reflectance that has a given colour under D65.
//
// In:  linear sRGB in [0,1]. Out: coefficients of SigmoidSpectrum (math/spectrum.h).
// Source: Jakob and Hanika, A Low-Dimensional Function Space for Efficient Spectral Upsampling
// (Eurographics 2019): same function family, same loss (CIELab under D65).
#pragma once

#include "math/colour.h"

namespace sunfleck::engine {

/// Returns 1/2 + x / (2 sqrt(1 + x^2)), without cancellation for x far below zero; 0 and 1 at
/// infinity.
template <class Real>
Real sigmoid(Real x);

/// Returns c such that the reflectance sigmoid(c[0] nm^2 + c[1] nm + c[2]) has the colour rgb under
/// D65.
///
/// The colour is exact to 1e-6 inside the family's gamut, which holds nearly all of sRGB, and the
/// nearest in CIELab outside. Only + - * / and sqrt in double are used: the result is
/// deterministic.
/// @param rgb  each in [0,1]; not all equal (a grey is a constant and needs no fit).
Triple fit_sigmoid(const Triple& rgb);

/// Variable of the fit: t = (nm - middle) / half range, in [-1,1] over the visible range, so that
/// the powers of t have similar magnitude.
inline constexpr double kMiddleNm = 0.5 * (kFirstNm + kLastNm);
inline constexpr double kHalfRangeNm = 0.5 * (kLastNm - kFirstNm);

/// Returns coefficients of 1, t, t^2 from a fit with the observer at 5 nm, for tables of many
/// colours.
/// @param near  coefficients of a similar colour as the start (some microseconds then); or null.
Triple fit_sigmoid_coarsely(const Triple& rgb, const Triple* near);

}  // namespace sunfleck::engine
