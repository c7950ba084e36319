// A photon path is visible, to a chain, exactly if the index accepts one of its photons.
#include "photon/photon_space.h"

#include "support/lantern.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// A patch of the lower sheet that accepts some kinds of photons.
std::vector<VisiblePoint> patch(std::uint8_t kinds) {
    std::vector<VisiblePoint> points;
    for (int i = 0; i < 64; ++i) {
        VisiblePoint point;
        point.disc.position = {0.5F + 0.02F * static_cast<float>(i % 8),
                               0.3F + 0.02F * static_cast<float>(i / 8), 0};
        point.disc.radius = 0.02F;
        point.disc.normal = {0, 0, 1};
        point.disc.kinds = kinds;
        points.push_back(point);
    }
    return points;
}

// 40,000 paths for each set of kinds; some dozens of them or more are visible.
TEST(PhotonSpace, visible_is_what_the_index_accepts) {
    const PassId id{3, 1};
    const Scene scene(testing_support::lantern());
    const PassScene pass(scene, id);
    const TransportSettings transport{DirectLight::sampled, 8};
    const PhotonTracer tracer(pass, transport);
    for (const int kinds : {1, 4, 6, 7}) {
        const VisiblePointIndex index({patch(static_cast<std::uint8_t>(kinds))}, 8);
        const VisiblePointOctree octree(index.points(), scene.sphere().center,
                                        scene.sphere().radius);
        const PhotonSpace space(tracer, index, octree);
        int visible = 0;
        for (std::uint32_t i = 0; i < 40'000; ++i) {
            std::uint64_t rays = 0;
            std::size_t taken = 0;
            tracer.trace(
                IndependentPoints(id).path(i),
                [&](const Photon& photon) {
                    taken += index.any(photon) ? 1 : 0;
                    return true;
                },
                rays);
            PhotonPath path;
            Statistics counts;
            space.trace(IndependentPoints(id).path(i), path, counts);
            ASSERT_EQ(space.height(path) == kVisible, taken > 0) << kinds << " " << i;
            ASSERT_GE(path.photons.size(), taken);  // none that counts was left out
            ASSERT_EQ(counts[Count::photon_rays], rays);
            visible += taken > 0 ? 1 : 0;
        }
        EXPECT_GT(visible, 40) << kinds;
    }
}

}  // namespace
}  // namespace sunfleck::engine
