// Path trials: photon paths through a guide, and what each of them brings to blocks of pixels.
//
// In:  visible points, a guide. Out: emission and light of paths that are no part of a picture.
#pragma once

#include "guide/emission_guide.h"
#include "photon/light_stratum.h"
#include "planning/judged_blocks.h"

#include <vector>

namespace sunfleck::engine {

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
PathTrials try_paths(const PhotonContext& context, const EmissionGuide& guide,
                     const BlockGrid& blocks, PassId pass, std::uint32_t count);

}  // namespace sunfleck::engine
