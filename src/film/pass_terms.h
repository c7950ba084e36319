// Contributions of a pass, and of a completed batch, to the sums of a film.
#pragma once

#include "film/film_sums.h"

#include <cstdint>
#include <span>

namespace sunfleck::engine {

/// Adds each term to its sum.
void add_all(std::span<FixedPoint> sums, std::span<const FixedPoint> terms);

/// Adds an AOV of a pass, pixel by pixel, channel by channel, times `weight`.
void add_aov(FixedPoints& sums, const PassImage& image, const AovRow& row, std::uint32_t weight);

/// Adds a light group of a pass, pixel by pixel, RGB, times `weight`.
void add_light_group(FixedPoints& sums, const PassImage& image, std::size_t light_group,
                     std::uint32_t weight);

/// Values that all passes of a batch share.
struct BatchTerms {
    double area = 0;           // mean disc area
    std::uint32_t weight = 1;  // of each pass
};

/// Adds the photons' light of one pass of a batch, which the image stores apart.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_photons(FilmSums& sums, const PassImage& image, const BatchTerms& terms,
                          OpenGroup& group);

/// Adds the squared luminance of a complete batch for pixels, blocks and the picture.
/// @param weight  of the batch.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_squares(FilmSums& sums, const OpenGroup& group, std::uint32_t weight);

}  // namespace sunfleck::engine
