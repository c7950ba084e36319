// Edge pixels: those near edges that the camera sees, and no others.
#include "planning/edge_pixels.h"

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A floor that ends at the middle of the picture, seen from above.
TEST(EdgePixels, lie_along_an_edge) {
    constexpr int kSide = 64;
    const Scene scene =
        scene_of(view("0 0 4  0 0 0  0 1 0", 28, kSide) + "LightSource \"distant\"\n" +
                 diffuse("0.5 0.5 0.5") + quad("-9 -9 0  0 -9 0  0 9 0  -9 9 0"));
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport;
    const CameraPathSettings camera;
    const PixelWindow window = window_of(scene.film());
    const EdgePixels edges =
        edge_pixels(view_of({pass, transport, camera, window, {1, 0}}), window);
    ASSERT_EQ(edges.size(), window.pixels());
    std::array<int, kSide> of_column{};
    for (std::size_t i = 0; i < edges.size(); ++i) {
        EXPECT_NE(edges[i], Edge::of_sight);
        of_column.at(i % kSide) += edges[i] == Edge::none ? 0 : 1;
    }
    EXPECT_EQ(of_column[8], 0);
    EXPECT_EQ(of_column[56], 0);
    EXPECT_EQ(of_column[31], kSide);
    EXPECT_EQ(of_column[32], kSide);
}

}  // namespace
}  // namespace sunfleck::engine
