// Luminance of pixels, of 8 x 8 blocks, and of the picture, from exact sums.
#pragma once

#include "aovs/block_grid.h"
#include "aovs/pass_image.h"
#include "core/exact_sum.h"
#include "film/film_key.h"
#include "math/colour.h"

#include <array>
#include <cstddef>
#include <vector>

namespace sunfleck::engine {

inline double luminance(const Triple& rgb) {
    return kLuminanceWeights[0] * rgb[0] + kLuminanceWeights[1] * rgb[1] +
           kLuminanceWeights[2] * rgb[2];
}

/// Three exact sums.
struct RgbSum {
    std::array<FixedPoint, 3> channel;

    RgbSum& operator+=(const RgbSum& other) {
        for (std::size_t c = 0; c < 3; ++c) channel[c] += other.channel[c];
        return *this;
    }
    RgbSum& operator-=(const RgbSum& other) {
        for (std::size_t c = 0; c < 3; ++c) channel[c] += -other.channel[c];
        return *this;
    }

    /// Returns the luminance of this sum divided by `terms`.
    double mean_luminance(double terms) const {
        const std::array<double, 3> rgb = {channel[0].to_double(), channel[1].to_double(),
                                           channel[2].to_double()};
        return luminance(rgb) / terms;
    }
};

/// Returns triple i of consecutive RGB sums.
inline RgbSum rgb_of(const std::vector<FixedPoint>& sums, std::size_t i) {
    return {{sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]}};
}

/// Returns the cells of a film's pixels for which photons' light is summed apart.
inline BlockGrid photon_cells_of(const FilmKey& key) {
    return photon_cells_of(key.width, key.height);
}

/// Returns blocks of these cells, which are the blocks of as many pixels.
/// @param block_size  in pixels, a multiple of a cell's.
inline BlockGrid blocks_of_cells(const FilmKey& key, std::size_t block_size) {
    const BlockGrid cells = photon_cells_of(key);
    return {static_cast<int>(cells.across()), static_cast<int>(cells.down()),
            block_size / cells.side()};
}

/// Returns the blocks of a film's pixels.
inline BlockGrid blocks_of(const FilmKey& key, std::size_t block_size) {
    return {key.width, key.height, block_size};
}

}  // namespace sunfleck::engine
