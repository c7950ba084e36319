// Uniform primary samples whose emission slots come from Sobol' points with a fresh digital shift
// each pass: every path is uniform by itself, and the paths of a pass are spread evenly.
//
// In:  a pass and the number of a path in it. Out: a slot reader for that path.
// Why it is exact: only each path's own distribution matters for unbiasedness (docs/method.md).
#pragma once

#include "sampler/primary_sample.h"
#include "sampler/sobol.h"

#include <array>

namespace sunfleck {

class EmissionPoints {
public:
    explicit EmissionPoints(PassId pass) : pass_(pass) {
        RandomStream shift = pass.stream(Purpose::sobol_shift, 0);
        for (std::uint64_t& s : shift_) s = shift.next_fraction();
    }

    class Reader {
    public:
        std::uint64_t operator()(std::uint32_t index) {
            if (index >= kSobolDimensions) return stream_.at(index);
            const std::uint64_t point = std::uint64_t{sobol(path_, index)} << 32U;
            return (point | below(index)) ^ shift_[index];
        }

    private:
        friend class EmissionPoints;
        Reader(const std::array<std::uint64_t, kSobolDimensions>& shift, std::uint32_t path,
               RandomStream stream)
            : shift_(shift), path_(path), stream_(stream) {}

        /// Jitter below 2^-32: the four words of one random block, and the first once more with
        /// its halves swapped. The shift alone makes all slots of a path uniform and independent;
        /// the jitter keeps different paths from having the same lower bits.
        std::uint32_t below(std::uint32_t index) {
            const std::uint64_t pair = stream_.at(index >> 1U & 1U);
            const auto word = static_cast<std::uint32_t>((index & 1U) != 0 ? pair : pair >> 32U);
            return index < 4 ? word : word << 16U | word >> 16U;
        }

        const std::array<std::uint64_t, kSobolDimensions>& shift_;
        std::uint32_t path_;
        RandomStream stream_;
    };

    /// Valid as long as this object.
    Reader path(std::uint32_t number) const {
        return {shift_, number, pass_.stream(Purpose::uniform_path, number)};
    }

private:
    PassId pass_;
    std::array<std::uint64_t, kSobolDimensions> shift_{};
};

static_assert(SlotReader<EmissionPoints::Reader>);

}  // namespace sunfleck
