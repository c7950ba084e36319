// The smooth reflectance that looks like a given colour under D65: three numbers found by a fit.
//
// In:  linear sRGB in [0,1]. Out: coefficients of SigmoidCurve (math/spectral_curve.h).
// Source: Jakob and Hanika, A Low-Dimensional Function Space for Efficient Spectral Upsampling
// (Eurographics 2019): same family, same loss (CIELab under D65).
#pragma once

#include "math/colour.h"

namespace sunfleck {

/// 1/2 + x / (2 sqrt(1 + x^2)), without cancellation for x far below zero; 0 and 1 at infinity.
template <class Real>
Real sigmoid(Real x);

/// c with sigmoid(c[0] nm^2 + c[1] nm + c[2]) the reflectance whose colour under D65 is rgb.
///
/// Exact (to 1e-6) inside the family's gamut, which holds nearly all of sRGB; the nearest in
/// CIELab elsewhere. Deterministic: double arithmetic of + - * / and sqrt.
/// @param rgb  each in [0,1]; not all equal (a grey is a constant and needs no fit).
Triple fit_sigmoid(const Triple& rgb);

}  // namespace sunfleck
