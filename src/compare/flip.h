// FLIP: the perceived difference of two pictures that a viewer alternates between.
//
// Source: Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, FLIP: A Difference
// Evaluator for Alternating Images (HPG 2020); Andersson, Nilsson, Shirley, Akenine-Moeller,
// Visualizing Errors in Rendered High Dynamic Range Images (Eurographics short papers 2021).
#pragma once

#include "compare/rgb_image.h"

#include <vector>

namespace sunfleck::engine {

/// A viewer 0.7 m from a screen with 3840 pixels on 0.7 m: the default of the papers.
inline constexpr float kPixelsPerDegree = 0.7F * 3840 / 0.7F * kPi / 180;

/// Returns the difference at each pixel, in [0,1], of the pictures as displayed: values are clamped
/// to [0,1]. Both pictures have one size and finite pixels.
std::vector<float> ldr_flip(const RgbImage& reference, const RgbImage& test,
                            float pixels_per_degree = kPixelsPerDegree);

/// Returns the exposures, in stops, between those at which the brightest value and the median of a
/// picture reach 0.85 after the ACES curve. If the median is black, it is taken over pixels that
/// are not black. Empty for a black picture.
std::vector<float> hdr_exposures(const RgbImage& reference);

/// Returns the maximum of ldr_flip() at each pixel over these exposures, after the ACES curve
/// (Narkowicz's fit). Empty for a black reference.
std::vector<float> hdr_flip(const RgbImage& reference, const RgbImage& test,
                            float pixels_per_degree = kPixelsPerDegree);

}  // namespace sunfleck::engine
