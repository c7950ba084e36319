// Path trials: photon paths through a guide, and what each of them brings to blocks of pixels.
//
// In:  visible points, a guide. Out: emission and light of paths that are no part of a picture.
#pragma once

#include "guide/emission_guide.h"
#include "photon/light_stratum.h"
#include "planning/pixel_buffer.h"

#include <vector>

namespace sunfleck::engine {

/// Blocks of pixels, row by row; those at the right and lower edges may be smaller.
class WorthBlocks {
public:
    static constexpr std::size_t kSide = 8;  // in pixels

    explicit WorthBlocks(const PixelWindow& window);

    std::size_t blocks() const { return pixels_.size(); }
    std::size_t block_of(std::size_t pixel) const {
        return pixel / width_ / kSide * across_ + pixel % width_ / kSide;
    }
    /// Returns the number of pixels of a block.
    double pixels(std::size_t block) const { return pixels_[block]; }
    std::vector<double> sums(const PixelValues& values) const;

private:
    std::size_t width_;
    std::size_t across_;
    std::vector<double> pixels_;
};

/// The luminance that a path alone brings to the pixels of a block: with the weight one.
struct PathLight {
    std::uint32_t path = 0;
    std::uint32_t block = 0;
    double luminance = 0;
};

struct PathTrials {
    std::vector<EmissionPoint> points;  // by path
    std::vector<PathLight> light;       // by path, then by block
};

/// @param pass  names the random numbers.
PathTrials try_paths(const PhotonContext& context, const LightChoice& lights,
                     const EmissionGuide& guide, const WorthBlocks& grid, PassId pass,
                     std::uint32_t count);

}  // namespace sunfleck::engine
