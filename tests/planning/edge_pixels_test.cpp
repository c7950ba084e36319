// Edge pixels: those near edges that the camera sees, and no others.
#include "planning/edge_pixels.h"

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSide = 64;

/// A floor that fills the right half of the picture, seen from above. @param parameters  of its
/// shape. @param cells  side of those with one path each.
EdgePixels edges_of_floor(const std::string& below, const std::string& parameters, int cells = 1) {
    const std::string floor =
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" [-9 -9 0  0 -9 0  "
        "0 9 0  -9 9 0] " +
        parameters + "\n";
    const Scene scene =
        scene_of(view("0 0 4  0 0 0  0 1 0", 28, kSide) + "LightSource \"distant\"\n" +
                 diffuse("0.5 0.5 0.5") + floor + below);
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport;
    const CameraPathSettings settings;
    CameraPass camera{pass, transport, settings, window_of(scene.film()), {1, 0}};
    camera.cells = cells;
    return edge_pixels(view_of(camera), camera.window);
}

/// Another floor lies far below.
class EdgePixelsByCells : public ::testing::TestWithParam<int> {};

TEST_P(EdgePixelsByCells, lie_along_an_edge) {
    const EdgePixels edges =
        edges_of_floor(quad("-99 -99 -9  99 -99 -9  99 99 -9  -99 99 -9"), "", GetParam());
    ASSERT_EQ(edges.size(), std::size_t{kSide * kSide});
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

INSTANTIATE_TEST_SUITE_P(EdgePixels, EdgePixelsByCells, ::testing::Values(1, 2));

/// Of a surface that few rays meet, a trial does not tell where it ends.
TEST(EdgePixels, are_where_few_discs_were_seen) {
    const EdgePixels edges = edges_of_floor("", "\"float alpha\" .05");
    for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_NE(edges[i], Edge::none);
    const EdgePixels of_half = edges_of_floor("", "\"float alpha\" .6");
    EXPECT_EQ(of_half[std::size_t{32 * kSide + 56}], Edge::none);
}

}  // namespace
}  // namespace sunfleck::engine
