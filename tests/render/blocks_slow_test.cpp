// Photon mapping against path tracing, block by block, with direct light sampled.
#include "render/block_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(Blocks, agree_with_path_tracing) {
    const Scene scene = room_with_a_lamp();
    expect_equal_blocks(blocks(scene, block_settings(DirectLight::sampled, 4'000), 250),
                        blocks_by_path(scene), "sampled");
}

}  // namespace
}  // namespace sunfleck::engine
