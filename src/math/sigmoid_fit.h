// The smooth reflectance that looks like a given colour under D65: three numbers found by a fit.
//
// In:  linear sRGB in [0,1]. Out: coefficients of SigmoidSpectrum (math/spectrum.h).
// Source: Jakob and Hanika, A Low-Dimensional Function Space for Efficient Spectral Upsampling
// (Eurographics 2019): same family, same loss (CIELab under D65).
#pragma once

#include "math/colour.h"

namespace sunfleck::engine {

/// 1/2 + x / (2 sqrt(1 + x^2)), without cancellation for x far below zero; 0 and 1 at infinity.
template <class Real>
Real sigmoid(Real x);

/// c with sigmoid(c[0] nm^2 + c[1] nm + c[2]) the reflectance whose colour under D65 is rgb.
///
/// Exact (to 1e-6) inside the family's gamut, which holds nearly all of sRGB; the nearest in
/// CIELab elsewhere. Deterministic: double arithmetic of + - * / and sqrt.
/// @param rgb  each in [0,1]; not all equal (a grey is a constant and needs no fit).
Triple fit_sigmoid(const Triple& rgb);

/// The fit's own variable: t = (nm - middle) / half range, in [-1,1] over the visible range, so
/// that its powers are of one size.
inline constexpr double kMiddleNm = 0.5 * (kFirstNm + kLastNm);
inline constexpr double kHalfRangeNm = 0.5 * (kLastNm - kFirstNm);

/// For tables of many colours: coefficients of 1, t, t^2, with the observer at 5 nm.
/// @param near  those of a colour close by, to start from (then some microseconds); or null.
Triple fit_sigmoid_coarsely(const Triple& rgb, const Triple* near);

}  // namespace sunfleck::engine
