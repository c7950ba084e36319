// Contributions of a pass, and of a completed batch, to the sums of a film.
#pragma once

#include "film/film_sums.h"

#include <cstdint>
#include <span>

namespace sunfleck::engine {

/// Adds each term to its sum.
void add_all(std::span<FixedPoint> sums, std::span<const FixedPoint> terms);

/// Adds an AOV of a pass, pixel by pixel, channel by channel.
void add_aov(FixedPoints& sums, const PassImage& image, const AovRow& row);

/// Adds a light group of a pass, pixel by pixel, RGB.
void add_light_group(FixedPoints& sums, const PassImage& image, std::size_t light_group);

/// Adds the photons' light of one pass, which the image stores apart.
/// @param area  mean disc area of the batch.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_photons(FilmSums& sums, const PassImage& image, double area, OpenGroup& group);

/// Adds the squared luminance of a complete batch for pixels, blocks and the picture.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_squares(FilmSums& sums, const OpenGroup& group);

}  // namespace sunfleck::engine
