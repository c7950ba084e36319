// EmissionPoints: uniform primary samples with stratified emission dimensions.
//
// The emission dimensions are Sobol' points with a new digital shift per pass: each path is uniform
// by itself, and the paths of a pass are evenly distributed. Other dimensions are independent.
//
// In:  a pass and the index of a path. Out: a primary-sample reader for that path.
// Estimators stay unbiased, because they depend on the distribution of each path alone
// (docs/method/sampling.md).
#pragma once

#include "core/hash.h"
#include "random_numbers/primary_sample.h"
#include "random_numbers/sobol.h"

#include <array>

namespace sunfleck::engine {

class EmissionPoints {
public:
    explicit EmissionPoints(PassId pass) : pass_(pass) {
        RandomStream shift = pass.stream(Purpose::sobol_shift, 0);
        for (std::uint64_t& s : shift_) s = shift.next_fraction();
        jitter_ = shift.next_fraction();
    }

    class Reader {
    public:
        std::uint64_t operator()(std::uint32_t index) {
            return index < kSobolDimensions ? emission_[index] : dimension_of(stream_, index);
        }

    private:
        friend class EmissionPoints;
        /// Adds jitter below 2^-32: the four words of two hashes, and the first one again with its
        /// halves exchanged. The shift makes the dimensions of a path uniform and independent; the
        /// jitter gives different paths different lower bits.
        Reader(const std::array<std::uint64_t, kSobolDimensions>& shift, std::uint64_t jitter,
               std::uint32_t path, RandomStream stream)
            : stream_(stream) {
            const std::uint64_t low = hash_joined(jitter, path);
            const std::uint64_t high = hash_joined(low, path);
            const std::uint64_t first = low >> 32U;
            const std::array<std::uint64_t, kSobolDimensions> below = {
                first, low & 0xFFFFFFFFU, high >> 32U, high & 0xFFFFFFFFU,
                (first << 16U | first >> 16U) & 0xFFFFFFFFU};
            for (std::size_t i = 0; i < kSobolDimensions; ++i)
                emission_[i] = (std::uint64_t{sobol(path, i)} << 32U | below[i]) ^ shift[i];
        }

        RandomStream stream_;
        std::array<std::uint64_t, kSobolDimensions> emission_{};  // read by every path
    };

    Reader path(std::uint32_t number) const {
        return {shift_, jitter_, number, pass_.stream(Purpose::uniform_path, number)};
    }

private:
    PassId pass_;
    std::array<std::uint64_t, kSobolDimensions> shift_{};
    std::uint64_t jitter_ = 0;
};

static_assert(PrimarySampleReader<EmissionPoints::Reader>);

}  // namespace sunfleck::engine
