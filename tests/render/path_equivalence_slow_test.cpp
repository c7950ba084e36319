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

TEST(PathEquivalence, floor_and_half_shadow_of_the_block) {
    expect_equivalent(diffuse_room("-.3 -.2 1.4  -.3 -.2 0  0 1 0", 35), {40, 8, 9});
}

}  // namespace
}  // namespace sunfleck::engine
