// What a pass, and a round when it is complete, add to the sums of a film.
#pragma once

#include "film/film_sums.h"

#include <cstdint>
#include <span>

namespace sunfleck {

/// Adds each term to its sum.
void add_all(std::span<FixedPoint> sums, std::span<const FixedPoint> terms);

/// Adds a layer of a pass, pixel after pixel, channel after channel, `weight` times.
void add_layer(FixedPoints& sums, const PassImage& image, const LayerRow& row,
               std::uint32_t weight);

/// Adds a layer of lights of a pass, pixel after pixel, RGB, `weight` times.
void add_light_layer(FixedPoints& sums, const PassImage& image, std::size_t light_layer,
                     std::uint32_t weight);

/// What all passes of a round have in common.
struct RoundTerms {
    double area = 0;           // of discs
    std::uint32_t weight = 1;  // how often they count
};

/// Adds what photons have brought in one pass of a round. The image holds it apart.
/// @return terms beyond kLargestTerm, which were cut there.
std::uint64_t add_photons(FilmSums& sums, const PassImage& image, const RoundTerms& terms,
                          OpenGroup& group);

/// Adds the squares of a round's luminance: of pixels, blocks and the picture. The round is
/// complete. @param weight  its.
/// @return terms beyond kLargestTerm, which were cut there.
std::uint64_t add_squares(FilmSums& sums, const OpenGroup& group, std::uint32_t weight);

}  // namespace sunfleck
