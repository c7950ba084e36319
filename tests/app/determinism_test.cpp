// The same bytes however a render is cut: the short table (determinism_slow_test.cpp: the long).
#include "app/determinism_support.h"

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;
using Determinism = DeterminismTest;

TEST_F(Determinism, small_cornell) {
    use("cornell", {"--resolution", "20x20", "--photons-per-pass", "1500"});
    part("reference", "0:16", 1);
    const Bytes reference = bytes("reference");
    ASSERT_GT(reference.exr.size(), 400U);
    part("threads", "0:16", 3);
    EXPECT_TRUE(bytes("threads") == reference);
    expect_whole(2, reference);
    expect_one_render_of_parts(2, reference);
    expect_one_render_of_passes({2}, reference);
    // The table can tell: one pass more is another picture.
    part("other", "0:17", 1);
    EXPECT_FALSE(bytes("other") == reference);
}

}  // namespace
}  // namespace sunfleck::engine
