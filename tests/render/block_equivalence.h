// Photon mapping against path tracing, block by block of 8 x 8 pixels: in each block the 99%
// interval of the ratio of brightness lies inside 1 +- 0.5%.
//
// The view is the floor of a diffuse room under a lamp to one side, less a rim of nearly two discs,
// so that none meets a wall. Discs of radius r see the mean of the light E around, off by
// r^2 / 8 * laplacian(E): here by less than 0.1%, with discs of a pixel's radius.
// Standard errors of a block are 0.05% (path tracing) and 0.08%: the interval is half as wide as
// what is allowed, and a fault of 0.8% in one block is found for sure.
#pragma once

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::testing_support {

inline constexpr int kBlock = 8;
inline constexpr int kBlocks = 3;  // each way
inline constexpr int kPasses = 16;

/// 1.16 x 1.16 m and 0.9 m high; the camera sees 1 x 1 m of the floor.
inline Scene room_with_a_lamp() {
    return scene_of(view("0 0 .8  0 0 0  0 1 0", 64, kBlock * kBlocks) + diffuse("0.4 0.4 0.4") +
                    "ReverseOrientation\n" + box({-0.58, -0.58, 0}, {0.58, 0.58, 0.9}) +
                    "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                    quad("-.56 -.56 .85  .46 -.56 .85  .46 .36 .85  -.56 .36 .85"));
}

/// Returns the brightness of each block over independent renders of a batch each.
inline std::vector<Estimate> blocks(const Scene& scene, RenderSettings settings, int renders) {
    std::vector<std::vector<double>> values(kBlocks * kBlocks);
    for (int i = 0; i < renders; ++i) {
        settings.seed = static_cast<std::uint64_t>(i);
        const MeanPicture picture = render_mean(scene, settings, kPasses);
        for (int b = 0; b < kBlocks * kBlocks; ++b) {
            const int x = b % kBlocks * kBlock;
            const int y = b / kBlocks * kBlock;
            values[static_cast<std::size_t>(b)].push_back(
                luminance(picture.mean(x, y, x + kBlock, y + kBlock)));
        }
    }
    std::vector<Estimate> result;
    result.reserve(values.size());
    for (const auto& of_block : values) result.push_back(Estimate::of(of_block));
    return result;
}

inline void expect_equal_blocks(const std::vector<Estimate>& photons,
                                const std::vector<Estimate>& path, const char* way) {
    for (std::size_t b = 0; b < path.size(); ++b)
        EXPECT_LT(worst_ratio(photons[b], path[b]), 0.005)
            << way << ", block " << b << ": " << photons[b].mean / path[b].mean << ", errors "
            << photons[b].error / photons[b].mean << ' ' << path[b].error / path[b].mean;
}

/// Light paths of three edges.
inline RenderSettings block_settings(DirectLight direct, std::uint32_t paths) {
    RenderSettings settings;
    settings.transport.max_depth = 3;
    settings.camera.radius_pixels = 1;
    settings.transport.direct = direct;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = paths;
    return settings;
}

inline std::vector<Estimate> blocks_by_path(const Scene& scene) {
    RenderSettings settings;
    settings.transport.max_depth = 3;
    settings.integrator = Integrator::path;
    return blocks(scene, settings, 700);
}

}  // namespace sunfleck::engine::testing_support
