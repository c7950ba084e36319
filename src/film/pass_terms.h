// What a pass, and a batch when it is complete, add to the sums of a film.
#pragma once

#include "film/film_sums.h"

#include <cstdint>
#include <span>

namespace sunfleck::engine {

/// Adds each term to its sum.
void add_all(std::span<FixedPoint> sums, std::span<const FixedPoint> terms);

/// Adds an AOV of a pass, pixel after pixel, channel after channel, `weight` times.
void add_aov(FixedPoints& sums, const PassImage& image, const AovRow& row, std::uint32_t weight);

/// Adds a light group of a pass, pixel after pixel, RGB, `weight` times.
void add_light_group(FixedPoints& sums, const PassImage& image, std::size_t light_group,
                     std::uint32_t weight);

/// What all passes of a batch have in common.
struct BatchTerms {
    double area = 0;           // of discs
    std::uint32_t weight = 1;  // how often they count
};

/// Adds what photons have brought in one pass of a batch. The image holds it apart.
/// @return terms beyond kLargestTerm, which were cut there.
std::uint64_t add_photons(FilmSums& sums, const PassImage& image, const BatchTerms& terms,
                          OpenGroup& group);

/// Adds the squares of a batch's luminance: of pixels, blocks and the picture. The batch is
/// complete. @param weight  its.
/// @return terms beyond kLargestTerm, which were cut there.
std::uint64_t add_squares(FilmSums& sums, const OpenGroup& group, std::uint32_t weight);

}  // namespace sunfleck::engine
