// Light tracing against path tracing.
#include "render/light_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(LightTracing, through_a_lens) {
    const std::string camera =
        "LookAt 0 -3 1  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 20 \"float lensradius\" "
        "0.2 \"float focaldistance\" 1.5\n" +
        film(32) + "WorldBegin\n";
    expect_equal(scene_of(camera + room_with_metal() + kLamp), Integrator::path, {24});
}

/// Vertex normals that lean: the adjoint of what the path tracer does with them.
TEST(LightTracing, of_bent_normals) {
    const std::string bent =
        "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "
        "\"normal N\" [-.5 -.4 1  .4 -.5 1  .5 .4 1  -.4 .5 1] \"integer indices\" [0 1 2 0 2 3]\n";
    const Scene scene = scene_of(view("0 -1.5 1.5  0 0 0  0 0 1", 40, 32) + diffuse("0.7 0.7 0.7") +
                                 bent + quad("-1 1 0  1 1 0  1 1 2  -1 1 2") + kLamp);
    expect_equal(scene, Integrator::path, {24});
}

}  // namespace
}  // namespace sunfleck::engine
