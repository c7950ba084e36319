// The two rooms: the doorway is the only way between them.

#include "procedural/cornell_door.h"

#include "core/random.h"
#include "scene_parts.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(CornellDoor, light_comes_into_the_cornell_box_through_the_doorway_only) {
    const std::vector<Part> parts = parts_of("cornell-door");
    RandomStream random(6, Purpose::test, 0, 0);
    int lit = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d here(-135 + 270 * random.next(), 2 + 276 * random.next(),
                         1 + 272 * random.next());
        const Vec3d there(152 + 276 * random.next(), 8 + 270 * random.next(),
                          1 + 272 * random.next());
        if (faces_between(parts, here, there).opaque > 0) continue;
        ++lit;
        const Vec3d at = here + (there - here) * ((145 - here.x) / (there.x - here.x));
        ASSERT_TRUE(at.y > 95 && at.y < 185 && at.z < 205) << at;
    }
    EXPECT_GT(lit, 20);
}

}  // namespace
}  // namespace sunfleck::engine
