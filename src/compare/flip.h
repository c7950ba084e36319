// FLIP: how different two pictures look to who flips between them.
//
// Sources: Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, FLIP: A Difference
// Evaluator for Alternating Images (HPG 2020); Andersson, Nilsson, Shirley, Akenine-Moeller,
// Visualizing Errors in Rendered High Dynamic Range Images (Eurographics short papers 2021).
#pragma once

#include "compare/rgb_image.h"

#include <vector>

namespace sunfleck::engine {

/// 0.7 m before a screen of 3840 pixels on 0.7 m: the papers' default.
inline constexpr float kPixelsPerDegree = 0.7F * 3840 / 0.7F * kPi / 180;

/// The difference at each pixel, [0,1], of the pictures as a screen shows them: light beyond [0,1]
/// is cut. Both have one size and no pixel that is not finite.
std::vector<float> ldr_flip(const RgbImage& reference, const RgbImage& test,
                            float pixels_per_degree = kPixelsPerDegree);

/// The exposures, in stops, at which a picture goes from its lights just not burnt out to its
/// median just not burnt out (ACES curve at 0.85). Of a picture that is black in its median the
/// median of what is not black counts. Empty for a black picture.
std::vector<float> hdr_exposures(const RgbImage& reference);

/// The greatest ldr_flip at each pixel over all those exposures, through the ACES curve (its fit by
/// Narkowicz). Empty for a black reference.
std::vector<float> hdr_flip(const RgbImage& reference, const RgbImage& test,
                            float pixels_per_degree = kPixelsPerDegree);

}  // namespace sunfleck::engine
