// Numbers for camera paths and direct light: over the 16 passes of a batch, each pair of
// dimensions of a pixel runs through as many Owen-scrambled Sobol' points as the pixel has camera
// paths in the batch, scrambled anew each batch.
//
// In:  a pass, a pixel; then dimensions in the order of asking. Out: numbers in (0,1).
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

/// A random permutation of the 32-bit fractions that keeps every elementary interval whole.
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

/// Which of its subpasses, and how many a pass has; the same number in all passes of a batch.
struct Subpass {
    std::uint32_t number = 0;
    std::uint32_t count = 1;
};

/// One of the camera paths that a pixel has in a subpass of a pass.
struct PathOfPixel {
    std::uint32_t number = 0;
    std::uint32_t log2_samples =
        0;  // 2^log2_samples there are, the same in all subpasses of a batch
    Subpass subpass = {};

    std::uint32_t count() const { return 1U << log2_samples; }
};

class BatchPoints {
public:
    /// @param pixel  any index that no other pixel of the pass has.
    BatchPoints(PassId pass, std::uint32_t pixel, const PathOfPixel& path = {})
        : seed_(pass.seed),
          index_((pass.number % kBatchPasses * path.subpass.count + path.subpass.number) *
                     path.count() +
                 path.number),
          unused_(static_cast<std::uint32_t>(
              std::countl_zero(kBatchPasses * path.subpass.count * path.count() - 1))),
          name_{0, pixel, pass.number / kBatchPasses,
                static_cast<std::uint32_t>(Purpose::camera) | pass.part << 16U} {}

    /// The next pair of dimensions.
    Vec2d next_2d() {
        const RandomBlock random = philox(name_, seed_);
        ++name_[0];
        // Owen's scrambling of the index permutes the points within each power of two.
        const std::uint32_t shuffled =
            batch_detail::owen_scramble(index_ << unused_, random[2]) >> unused_;
        return {unit(batch_detail::owen_scramble(sobol(shuffled, 0), random[0])),
                unit(batch_detail::owen_scramble(sobol(shuffled, 1), random[1]))};
    }

    /// Other dimensions, for a branch of the path: as far from these as chance has it.
    BatchPoints branch() const {
        BatchPoints other = *this;
        other.name_[0] = name_[0] * 0x9E3779B9U + 0x7F4A7C15U;
        return other;
    }

    /// One number; takes a pair of dimensions.
    double next() { return next_2d().x; }

private:
    static double unit(std::uint32_t fraction) {
        return (static_cast<double>(fraction) + 0.5) * 0x1p-32;
    }

    std::uint64_t seed_;
    std::uint32_t index_;   // of the point in its batch
    std::uint32_t unused_;  // bits of a word beyond those of an index
    RandomBlock name_;
};

}  // namespace sunfleck::engine
