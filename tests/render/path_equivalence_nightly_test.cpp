// Photon mapping against path tracing under varnish: within 1%, with 99% confidence.
#include "render/path_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// Varnished walls, smooth and satin: what lies below the coat is gathered, the coat followed.
TEST(PathEquivalence, varnish_on_a_diffuse_wall) {
    for (const char* roughness : {"0", "0.3"}) {
        SCOPED_TRACE(roughness);
        const Scene scene = scene_of(
            view("0 -1.4 1.2  0 .2 .5  0 0 1", 25, kSize) + diffuse("0.5 0.5 0.5") +
            quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") +
            "Material \"coateddiffuse\" \"rgb reflectance\" [0.7 0.3 0.2] \"float roughness\" " +
            roughness + " \"bool remaproughness\" false\n" +
            quad("-1 1 0  1 1 0  1 -.2 1.2  -1 -.2 1.2") +
            "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nReverseOrientation\n" +
            diffuse("0.5 0.5 0.5") + quad("-.8 -1.6 2.5  .8 -1.6 2.5  .8 0 2.5  -.8 0 2.5"));
        expect_equivalent(scene, {90, 45, 120, 0.01, 0.01});
    }
}

}  // namespace
}  // namespace sunfleck::engine
