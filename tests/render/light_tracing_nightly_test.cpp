// Light tracing against photons, where path tracing finds nothing.
#include "render/light_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A caustic of the sun: no path from the camera can find it.
TEST(LightTracingNightly, of_a_caustic) {
    const Scene scene =
        scene_of(view("2 -1 1  .57 -.2 0  0 0 1", 22, 32) +
                 "LightSource \"distant\" \"point3 from\" [-1 0 1.2]\n" + diffuse("0.7 0.7 0.7") +
                 quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                 "Material \"dielectric\" \"spectrum eta\" \"glass-F11\"\nTranslate -.1 -.2 .8\n"
                 "Shape \"sphere\" \"float radius\" 0.4\n");
    expect_equal(scene, Integrator::sppm, {40, 0.015});
}

}  // namespace
}  // namespace sunfleck::engine
