// The lantern: light leaves it through its pane alone.

#include "procedural/opal.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Opal, light_leaves_the_lantern_through_the_pane_alone) {
    const std::vector<Part> parts = parts_of("opal");
    const Vec3d lamp(-15.12, 4.02, 9.8);
    RandomStream random(6, Purpose::test, 0, 0);
    int out = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto coordinate = [&] { return 2 * random.next() - 1; };
        const Vec3d way = Vec3d(coordinate(), coordinate(), coordinate()).normalized();
        const Met met = faces_between(parts, lamp, lamp + way * 28);
        if (met.opaque > 0) continue;
        ++out;
        ASSERT_EQ(met.glass, 2) << way;
    }
    EXPECT_GT(out, 60);
}

}  // namespace
}  // namespace sunfleck::engine
