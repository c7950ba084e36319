// BatchPoints: random numbers of camera paths and direct light, stratified over a batch.
//
// Each pair of dimensions of a pixel takes Owen-scrambled Sobol' points, as many as the pixel has
// camera paths in the 16 passes of a batch; each batch is scrambled anew.
//
// In:  a pass and a pixel, then dimensions in the order of requests. Out: numbers in (0,1).
// Source: Owen 1995; hashed nested scrambling: Laine and Karras 2011, Burley 2020 (JCGT 9(4));
// constants of the hash from Vegdahl 2021.
#pragma once

#include "math/vector.h"
#include "math/wavelengths.h"
#include "random_numbers/sobol.h"

#include <bit>

namespace sunfleck::engine {

namespace batch_detail {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1U) & 0x55555555U) | ((x & 0x55555555U) << 1U);
    x = ((x >> 2U) & 0x33333333U) | ((x & 0x33333333U) << 2U);
    x = ((x >> 4U) & 0x0F0F0F0FU) | ((x & 0x0F0F0F0FU) << 4U);
    x = ((x >> 8U) & 0x00FF00FFU) | ((x & 0x00FF00FFU) << 8U);
    return (x >> 16U) | (x << 16U);
}

/// A random permutation of 32-bit fractions that maps elementary intervals to elementary intervals.
constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x);
    x ^= x * 0x3D20ADEAU;
    x += seed;
    x *= (seed >> 16U) | 1U;
    x ^= x * 0x05526C56U;
    x ^= x * 0x53A22864U;
    return reverse_bits(x);
}

}  // namespace batch_detail

/// One of the camera paths of a pixel in a pass.
struct PathOfPixel {
    std::uint32_t number = 0;
    std::uint32_t log2_samples = 0;  // paths of the pixel, the same in all passes of a batch

    std::uint32_t count() const { return 1U << log2_samples; }
};

class BatchPoints {
public:
    /// @param pixel  index that is unique in the pass.
    BatchPoints(PassId pass, std::uint32_t pixel, const PathOfPixel& path = {})
        : seed_(pass.seed),
          index_(pass.number % kBatchPasses * path.count() + path.number),
          unused_(static_cast<std::uint32_t>(std::countl_zero(kBatchPasses * path.count() - 1))),
          name_{0, pixel, pass.number / kBatchPasses,
                static_cast<std::uint32_t>(Purpose::camera) | pass.substream << 16U} {}

    /// Returns the next pair of dimensions.
    Vec2d next_2d() {
        const RandomBlock random = philox(name_, seed_);
        ++name_[0];
        // Owen scrambling of the index permutes the points within each power of two.
        const std::uint32_t shuffled =
            batch_detail::owen_scramble(index_ << unused_, random[2]) >> unused_;
        return {unit(batch_detail::owen_scramble(sobol(shuffled, 0), random[0])),
                unit(batch_detail::owen_scramble(sobol(shuffled, 1), random[1]))};
    }

    /// Returns independent dimensions for a branch of the path.
    BatchPoints branch() const {
        BatchPoints other = *this;
        other.name_[0] = name_[0] * 0x9E3779B9U + 0x7F4A7C15U;
        return other;
    }

    /// Returns one number; it uses up a pair of dimensions.
    double next() { return next_2d().x; }

private:
    static double unit(std::uint32_t fraction) {
        return (static_cast<double>(fraction) + 0.5) * 0x1p-32;
    }

    std::uint64_t seed_;
    std::uint32_t index_;   // index of the point in its batch
    std::uint32_t unused_;  // bits of a word that the index does not use
    RandomBlock name_;
};

}  // namespace sunfleck::engine
