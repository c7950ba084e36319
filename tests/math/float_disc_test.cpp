// The disc map in float is the one in double, to the last bits of a float.
#include "math/float_disc.h"

#include "core/random.h"
#include "math/warp.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

void expect_same(float u, float v) {
    const FloatDiscPoint at = float_disc_point({u, v});
    const DiscPoint exact = concentric_disc_point({u, v});
    EXPECT_NEAR(at.position.x, exact.position.x, 2e-7);
    EXPECT_NEAR(at.position.y, exact.position.y, 2e-7);
    const double height2 = 1 - exact.radius2;
    EXPECT_NEAR(at.height2, height2, 3e-7 * height2);
}

TEST(FloatDisc, agrees_with_the_map_in_double) {
    RandomStream stream(4, Purpose::test, 0, 0);
    for (int i = 0; i < 100000; ++i) {
        const float u = stream.next_float();
        expect_same(u, stream.next_float());
    }
}

TEST(FloatDisc, at_the_border_and_in_the_middle) {
    const float first = 0x1p-24F;
    for (const float u : {first, 0.25F, 0.5F, 0.75F, 1 - first})
        for (const float v : {first, 0.25F, 0.5F, 0.75F, 1 - first}) expect_same(u, v);
}

}  // namespace
}  // namespace sunfleck::engine
