// Photon mapping against path tracing where both converge: an equivalence test. The 99% interval
// of the ratio of their brightness must lie inside 1 +- 0.5% in every view; inside 1% where both
// are slow.
//
// A disc blurs light by order r^2, and by order r where a surface ends: each view shows one plane
// away from its edges, with discs of a pixel's width.
#include "render/path_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A room with coloured walls, open to one side, with an area light and a block.
Scene diffuse_room(const std::string& look, double fov) {
    return scene_of(view(look, fov, kSize) + diffuse("0.6 0.6 0.6") +
                    quad("-1 1 0  1 1 0  1 1 2  -1 1 2") + quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
                    quad("-1 -1 2  -1 1 2  1 1 2  1 -1 2") + diffuse("0.6 0.1 0.1") +
                    quad("-1 -1 0  -1 1 0  -1 1 2  -1 -1 2") + diffuse("0.1 0.5 0.1") +
                    quad("1 -1 0  1 -1 2  1 1 2  1 1 0") + diffuse("0.6 0.6 0.6") +
                    box({0.2, 0, 0}, {0.9, 0.7, 0.6}) +
                    "AreaLightSource \"diffuse\" \"rgb L\" [10 9 7]\nReverseOrientation\n" +
                    quad("-.4 -.6 1.9  .4 -.6 1.9  .4 .2 1.9  -.4 .2 1.9"));
}

TEST(PathEquivalence, red_wall) {
    expect_equivalent(diffuse_room("0.5 0 1  -1 0 1  0 0 1", 50), {80, 10, 10});
}

TEST(PathEquivalence, floor_and_half_shadow_of_the_block) {
    expect_equivalent(diffuse_room("-.3 -.2 1.4  -.3 -.2 0  0 1 0", 35), {40, 8, 9});
}

TEST(PathEquivalence, rough_metal) {
    expect_equivalent(rough_objects("-.85 -1.5 1  -.85 .8 .85  0 0 1", 20),
                      {120, 10, 24, 0.005, 0.01});
}

/// A lamp behind smooth glass over rough metal: photons bring its light, the camera path must not.
TEST(PathEquivalence, rough_metal_lit_through_smooth_glass) {
    const Scene scene =
        scene_of(view("0 -1 .9  0 0 0  0 0 1", 20, kSize) +
                 "Material \"conductor\" \"float roughness\" 0.5 \"bool remaproughness\" false\n" +
                 quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") + "Material \"dielectric\"\n" +
                 box({-1, -1, 1}, {1, 1, 1.1}) +
                 "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nReverseOrientation\n" +
                 diffuse("0.5 0.5 0.5") + quad("-.8 -.8 1.5  .8 -.8 1.5  .8 .8 1.5  -.8 .8 1.5"));
    expect_equivalent(scene, {160, 20, 20, 0.01, 0.01});
}

}  // namespace
}  // namespace sunfleck::engine
