// Contributions of a pass, and of a completed batch, to the sums of a film.
#pragma once

#include "film/film_sums.h"

#include <cstdint>
#include <span>

namespace sunfleck::engine {

/// Adds each term to its sum.
void add_all(std::span<FixedPoint> sums, std::span<const FixedPoint> terms);

/// The image of a pass, whose terms are shifted down by some bits: its weight (pass_weight.h).
struct WeighedImage {
    const PassImage& image;
    unsigned bits_less = 0;
};

/// Adds an AOV of a pass, pixel by pixel, channel by channel.
void add_aov(FixedPoints& sums, const WeighedImage& pass, const AovRow& row);

/// Adds a light group of a pass, pixel by pixel, RGB.
void add_light_group(FixedPoints& sums, const WeighedImage& pass, std::size_t light_group);

/// Adds the photons' light of one pass, which the image stores apart.
/// @param area  mean disc area of the batch.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_photons(FilmSums& sums, const WeighedImage& pass, double area, OpenGroup& group);

/// Where squared luminances of batches are summed.
struct SquareSums {
    FixedPoints& pixels;
    FixedPoints& blocks;
    FixedPoint& image;
    FixedPoints& photon_blocks;  // empty without discs
    FixedPoint& photon_image;
};

/// Returns the sums of whole batches.
SquareSums squares_of_whole(FilmSums& sums);
/// Returns the sums of early batches.
SquareSums squares_of_early(FilmSums& sums);

/// Adds the squared mean luminance of a complete batch for pixels, blocks and the picture.
/// @param passes  of the batch, by weight. @param factor  of each square.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_squares(const FilmKey& key, const OpenGroup& batch, double passes, double factor,
                          const SquareSums& sums);

/// Adds photons' luminance of an early batch times an area.
/// @return the number of terms clamped to kLargestTerm.
std::uint64_t add_early_area(FilmSums& sums, const OpenGroup& batch, double area);

}  // namespace sunfleck::engine
