// Photon mapping against path tracing, block by block, with all light by photons.
#include "render/block_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(BlocksNightly, agree_with_path_tracing) {
    const Scene scene = room_with_a_lamp();
    expect_equal_blocks(blocks(scene, block_settings(DirectLight::photons, 20'000), 120),
                        blocks_by_path(scene), "photons");
}

}  // namespace
}  // namespace sunfleck::engine
